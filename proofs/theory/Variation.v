(* Variation diminution and total positivity fail for every degree k >= 3 and every r <> 1: both because a function has two local maxima
   (TwoMaxima.v). Where G_i is lower at x2 than at x1 < x2 and x3 > x2, the curve of control values G_i minus a constant changes its sign
   four times and its polygon twice; and with A and B the sums of the functions before and after G_i, the minor of (A, G_i, B) at x1, x2, x3 is
   negative, as A + G_i + B = 1, A does not rise and B does not fall: so one of the minors whose sum it is is negative. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis StatementsCurves Cumulative Windows TwoMaxima MaximaBound.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* how often a sequence of numbers changes its sign, zeros left out *)
Section Changes.
Variable R : realFieldType.
Implicit Type l : seq R.
Fixpoint alternations (x : R) l : nat := if l is y :: l' then ((x * y < 0)%R + alternations y l')%N else 0.
Definition changes l : nat := if [seq x <- l | x != 0] is x :: l' then alternations x l' else 0.
Lemma alternations_same x j l : alternations x (nseq j x ++ l) = alternations x l.
Proof. by elim: j => //= j ->; rewrite ltNge -expr2 sqr_ge0. Qed.
(* one that differs from the others makes two changes at most *)
Lemma changes_bump x y j j' : (changes (nseq j x ++ y :: nseq j' x) <= 2)%N.
Proof.
rewrite /changes filter_cat /= !filter_nseq.
have E c a : alternations c (nseq a x) = (((0 < a)%N && (c * x < 0)) : nat).
  by case: a => //= a; have := alternations_same x a [::]; rewrite cats0 => ->; rewrite addn0.
case: (x != 0); last by rewrite !mul0n /=; case: (y != 0).
rewrite !mul1n; case: (y != 0); last first.
  rewrite -nseqD; case: (j + j')%N => //= a; rewrite E; by case: (_ && _).
case: j => [|j] /=; first by rewrite E; case: (_ && _).
by rewrite alternations_same /= E; case: (_ < _); case: (_ && _).
Qed.
Lemma map_const_iota (d : nat -> R) x a j : (forall i, (a <= i < a + j)%N -> d i = x) -> [seq d i | i <- iota a j] = nseq j x.
Proof.
elim: j a => //= j IH a h; rewrite h ?leqnn ?addnS ?leq_addr //; congr (_ :: _); apply: IH => i /andP[h1 h2].
by apply: h; rewrite ltnW //= addnS.
Qed.
End Changes.

(* ---- the knots: those of TwoMaxima.v, the first and the last one k times more ---- *)
Section Clamp.
Variable R : realFieldType.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable k : nat.
Definition clamp (j : nat) : R := t (minn (j - k) k.+1).
Lemma clamp_mono j : clamp j <= clamp j.+1.
Proof. by apply: (t_le t_mono); clear; lia. Qed.
Lemma clamp0 j : (j <= k)%N -> clamp j = t 0%N.
Proof. by move=> h; rewrite /clamp; congr (t _); move: h; clear; lia. Qed.
Lemma clamp1 j : (k.*2.+1 <= j)%N -> clamp j = t k.+1.
Proof. by rewrite -addnn => h; rewrite /clamp; congr (t _); move: h; clear; lia. Qed.
Lemma clampG r x : G (wt r clamp) clamp k k x = G (wt r t) t k 0 x.
Proof.
have := @shift R (phi r) clamp k k 0 x; rewrite add0n => <-.
apply: (@locality R (phi r) _ _ k 0 x) => j /andP[_ h].
by rewrite /clamp; congr (t _); move: h; clear; lia.
Qed.
End Clamp.

Section Variation.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Hypothesis r_neq1 : r != 1.
Variable k : nat.
Hypothesis k3 : (3 <= k)%N.
Lemma open_two_maxima : exists (t : nat -> R) x1 x2 x3, let f := value r t (k.*2 + k.+1) k k in
  [/\ forall i, t i <= t i.+1, Uopen t k.*2 k, Uinner t k.*2 k &
   [/\ t 0%N < x1, x1 < x2, x2 < x3, x3 < t (k.*2 + k.+1)%N & [/\ f x2 < f x1, f x2 < f x3, f (t 0%N) = 0 & f (t (k.*2 + k.+1)%N) = 0]]].
Proof.
have [t [tm t0 _ [x1 [x2 [x3 [h1 h2 h3 h4 [g1 g2]]]]]]] := Conj3_1_strong_continuous_printed_false r_gt0 r_neq1 k3.
pose u := clamp t k; have um := clamp_mono tm k : forall i, u i <= u i.+1.
set m := (k.*2 + k.+1)%N.
have u0 j : (j <= k)%N -> u j = t 0%N by exact: clamp0.
have u1 j : (k.*2.+1 <= j)%N -> u j = t k.+1 by exact: clamp1.
have uk : u k.*2.+1 = t k.+1 by apply: u1.
have um1 : u m = t k.+1 by apply: u1; rewrite /m addnS ltnS leq_addr.
have ho : Uopen u k.*2 k by split; [rewrite !u0|rewrite uk um1|rewrite u0 // uk].
have U := Uopen_t0 ho; have kk : (k + k.+1 = k.*2.+1)%N by rewrite addnS addnn.
have kn : (k <= k.*2)%N by rewrite -addnn leq_addr.
have vG x : x < t k.+1 -> value r u m k k x = G (wt r t) t k 0 x by move=> h; rewrite value_in ?um1 // clampG.
have e2 := lt_trans h2 (lt_trans h3 h4).
(* neither the first nor the last span is the only one *)
have lt1 : t 0%N < t k.
  rewrite lt_neqAle (t_le tm) // andbT; apply/negP => /eqP e.
  have [_] := @last_falls R r r_gt0 t tm k 0 x2 x3 ltac:(by rewrite add0n -e; exact: ltW (lt_trans h1 h2)) h3 h4.
  by move/(_ (ltnW (ltnW k3))); rewrite ltNge ltW.
have lt2 : t 1%N < t k.+1.
  rewrite lt_neqAle (t_le tm) // andbT; apply/negP => /eqP e.
  have [_] := @first_rises R r r_gt0 t tm 0 k x1 x2 (ltW h1) h2 ltac:(by rewrite e; exact: lt_trans h3 h4).
  by move/(_ (ltnW (ltnW k3))); rewrite ltNge ltW.
exists u, x1, x2, x3; split=> //.
  move=> y hy; apply: (@inside_mult R u um k.*2 k k kn).
  by rewrite kk uk u0 //; move: hy; rewrite u0 // um1.
rewrite u0 // um1; split=> //; split.
- by rewrite !vG ?(lt_trans h3 h4).
- by rewrite !vG ?(lt_trans h3 h4).
- rewrite vG //; apply: T3_5_1_left => //; first exact: wt_left.
  by rewrite add0n => -[e _]; rewrite e ltxx in lt1.
rewrite -um1 (value_tmE r_gt0 um) //; last by rewrite /m; move: k3; clear; lia.
have [p1 p2 p3] := last_spanP um U; case: eqP => // e; move: lt2; rewrite -um1 -p3 -e /u /clamp.
have -> : minn (k.+1 - k) k.+1 = 1%N by clear; lia.
by rewrite ltxx.
Qed.
End Variation.

(* X.variation is false for every k >= 3 and every r <> 1: U open, inner multiplicities at most k, control values d_0, .., d_n and points of
   [t_0,t_m] such that the curve changes its sign more often along them than the control values do *)
Theorem X_variation_printed_false (R : realFieldType) (r : R) k : 0 < r -> r != 1 -> (3 <= k)%N ->
  exists n (t d : nat -> R) (l : seq R), [/\ forall i, t i <= t i.+1, Uopen t n k, Uinner t n k, sorted <%R l &
    (forall x, x \in l -> t 0%N <= x <= t (n + k.+1)%N) /\
    (changes [seq d i | i <- iota 0 n.+1] < changes [seq coordinate r t n k d x | x <- l])%N].
Proof.
move=> r0 r1 k3; have [t [x1 [x2 [x3 /= [tm ho hi [h1 h2 h3 h4 [g1 g2 z0 z1]]]]]]] := open_two_maxima r0 r1 k3.
set n := k.*2 in ho hi h4 g1 g2 z0 z1; set m := (n + k.+1)%N in ho hi h4 g1 g2 z0 z1; set f := value r t m k k in g1 g2 z0 z1.
have U := Uopen_t0 ho; have kn : (k <= n)%N by rewrite /n -addnn leq_addr.
have [c [c0 cl]] : exists c, f x2 < c /\ (c < f x1 /\ c < f x3).
  have : f x2 < Num.min (f x1) (f x3) by rewrite lt_minr g1.
  by move=> /midf_lt[a b]; exists ((f x2 + Num.min (f x1) (f x3)) / 2%:R); move: b; rewrite lt_minr => /andP.
have cp : 0 < c by apply: le_lt_trans c0; apply: value_ge0.
pose d (i : nat) : R := (i == k)%:R - c.
have C x : t 0%N <= x <= t m -> coordinate r t n k d x = f x - c.
  move=> hx; rewrite -[LHS](P4_1_4_printed r0 tm U (fun i => (i == k)%:R) (- c) ho hx); congr (_ - _).
  rewrite /coordinate (big_cat_nat _ (n := k)) //=; last exact: leqW.
  rewrite big_nat_cond big1 ?add0r; last by move=> i /andP[/andP[_ ik] _]; rewrite ltn_eqF // mul0r.
  rewrite big_ltn // eqxx mul1r big_nat_cond big1 ?addr0 // => i /andP[/andP[ik _] _].
  by rewrite gtn_eqF // mul0r.
have D : (changes [seq d i | i <- iota 0 n.+1] <= 2)%N.
  have -> : [seq d i | i <- iota 0 n.+1] = nseq k (- c) ++ (1 - c) :: nseq k (- c); last exact: changes_bump.
  have -> : n.+1 = (k + k.+1)%N by rewrite addnS addnn.
  rewrite iotaD map_cat add0n [iota k _]/= map_cons {2}/d eqxx; congr (_ ++ _ :: _).
    by apply: map_const_iota => i /andP[_ ik]; rewrite /d ltn_eqF // sub0r.
  by apply: map_const_iota => i /andP[ik _]; rewrite /d gtn_eqF // sub0r.
have x13 := lt_trans h2 h3; have x01 := ltW h1.
exists n, t, d, [:: t 0%N; x1; x2; x3; t m]; split=> //.
  by rewrite /= h1 h2 h3 h4.
have in1 x : x \in [:: t 0%N; x1; x2; x3; t m] -> t 0%N <= x <= t m.
  rewrite !inE => /orP[/eqP ->|/orP[/eqP ->|/orP[/eqP ->|/orP[/eqP ->|/eqP ->]]]]; rewrite ?lexx ?(ltW U) //.
  - by rewrite x01 (ltW (lt_trans x13 h4)).
  - by rewrite (ltW (lt_trans h1 h2)) (ltW (lt_trans h3 h4)).
  - by rewrite (ltW (lt_trans h1 x13)) (ltW h4).
split=> //.
apply: (leq_ltn_trans D).
rewrite /changes !map_cons !C ?in1 ?inE ?eqxx ?orbT //.
have [f1 f3] := cl; rewrite /= z0 z1.
have n1 : 0 < f x1 - c by rewrite subr_gt0. have n3 : 0 < f x3 - c by rewrite subr_gt0. have n2 : f x2 - c < 0 by rewrite subr_lt0.
have n0 : 0 - c < 0 by rewrite sub0r oppr_lt0.
by rewrite !(gt_eqF n1, gt_eqF n3, lt_eqF n2, lt_eqF n0) /= (nmulr_rlt0 _ n0) (pmulr_rlt0 _ n1) (nmulr_rlt0 _ n2) (pmulr_rlt0 _ n3) n0 n1 n2 n3.
Qed.

(* ---- a negative minor of order 3 ---- *)
Section Minor.
Variable R : realFieldType.
Lemma det3 (F : nat -> nat -> R) : \det (\matrix_(i < 3, j < 3) F i j) =
  F 0%N 0%N * (F 1%N 1%N * F 2%N 2%N - F 1%N 2%N * F 2%N 1%N) - F 0%N 1%N * (F 1%N 0%N * F 2%N 2%N - F 1%N 2%N * F 2%N 0%N) + F 0%N 2%N * (F 1%N 0%N * F 2%N 1%N - F 1%N 1%N * F 2%N 0%N).
Proof.
rewrite (expand_det_row _ ord0) !big_ord_recl big_ord0 /cofactor !(expand_det_row _ ord0) !big_ord_recl !big_ord0 /cofactor !det_mx11.
by rewrite !mxE /= /bump /= !(addn0, add0n, addn1) !(expr0, expr1, sqrrN, expr1n); ring.
Qed.
(* a sum of numbers that is negative has a negative one among them *)
Lemma sum_lt0 (a b : nat) (F : nat -> R) : \sum_(a <= i < b) F i < 0 -> exists2 i, (a <= i < b)%N & F i < 0.
Proof.
move=> h; have : has (fun i => F i < 0) (index_iota a b).
  apply/negPn; rewrite -all_predC; apply/negP => /allP H; move: h; rewrite ltNge; case/negP.
  by rewrite big_seq; apply: sumr_ge0 => i /H /=; rewrite -leNgt.
by case/hasP => i; rewrite mem_index_iota => hi lt; exists i.
Qed.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k i : nat.
Hypothesis i_n : (i <= n)%N.
Hypothesis ho : Uopen t n k.
Local Notation m := (n + k.+1)%N.
Local Notation f := (value r t m k).
(* G_i lower at y than at x < y and z > y makes a negative minor of G_a, G_i, G_b at x, y, z for some a < i < b *)
Lemma negative_minor x y z : t 0%N <= x -> x < y -> y < z -> z <= t m -> f i y < f i x -> f i y < f i z ->
  exists a b, (a < i < b)%N /\ (b <= n)%N /\
  \det (\matrix_(p < 3, q < 3) f (nth 0%N [:: a; i; b] q) (nth 0 [:: x; y; z] p)) < 0.
Proof.
move=> x0 xy yz zm g1 g2; have U := Uopen_t0 ho.
pose T u := \sum_(i <= j < n.+1) f j u. pose B u := \sum_(i.+1 <= j < n.+1) f j u. pose A u := \sum_(0 <= j < i) f j u.
have hx : t 0%N <= x <= t m by rewrite x0 (ltW (lt_le_trans (lt_trans xy yz) zm)).
have hy : t 0%N <= y <= t m by rewrite (le_trans x0 (ltW xy)) (ltW (lt_le_trans yz zm)).
have hz : t 0%N <= z <= t m by rewrite zm (le_trans x0 (ltW (lt_trans xy yz))).
have step a u : (a <= n)%N -> \sum_(a <= j < n.+1) f j u = coordinate r t n k (fun j => (a <= j)%N%:R) u.
  move=> an; rewrite /coordinate [RHS](big_cat_nat _ (n := a)) //=; last exact: leqW.
  rewrite [X in _ = X + _]big_nat_cond [X in _ = X + _]big1 ?add0r; last by move=> j /andP[/andP[_ ja] _]; rewrite leqNgt ja mul0r.
  by apply: eq_big_nat => j /andP[-> _]; rewrite mul1r.
have mono a u v : t 0%N <= u -> u <= v -> v <= t m -> \sum_(a <= j < n.+1) f j u <= \sum_(a <= j < n.+1) f j v.
  move=> u0 uv vm; case: (leqP a n) => an; last by rewrite !big_geq.
  rewrite !step //; apply: monotone_curve => // j _; rewrite ler_nat; by case: (leqP a j) => // h; rewrite leqW.
have TB u : T u = f i u + B u by rewrite /T big_ltn.
have one u : t 0%N <= u <= t m -> A u + f i u + B u = 1.
  move=> hu; rewrite -addrA -TB /A /T -big_cat_nat //=; last exact: leqW.
  have := P4_1_4_printed r_gt0 t_mono U (fun _ => 0) 1 ho hu.
  rewrite /coordinate big1 ?add0r; last by move=> j _; rewrite mul0r.
  by move=> ->; apply: eq_bigr => j _; rewrite ?add0r mul1r.
have T1 : T x <= T y by apply: mono => //; [exact: ltW|case/andP: hy].
have B1 : B x <= B y by apply: mono => //; [exact: ltW|case/andP: hy].
have B2 : B y <= B z by apply: mono => //; [case/andP: hy|exact: ltW].
have B0 : B x < B y by rewrite ltNge; apply/negP => c; have := ltr_le_add g1 c; rewrite -!TB ltNge T1.
pose D a1 a2 a3 b1 b2 b3 : R := a1 * (f i y * b3 - b2 * f i z) - f i x * (a2 * b3 - b2 * a3) + b1 * (a2 * f i z - f i y * a3).
have neg : D (A x) (A y) (A z) (B x) (B y) (B z) < 0.
  have E u : t 0%N <= u <= t m -> A u = 1 - f i u - B u by move=> /one <-; ring.
  have -> : D (A x) (A y) (A z) (B x) (B y) (B z) = - ((f i x - f i y) * (B z - B y) + (f i z - f i y) * (B y - B x)).
    by rewrite /D !E //; ring.
  rewrite oppr_lt0 ltr_paddl //; first by rewrite mulr_ge0 // subr_ge0 // ltW.
  by rewrite mulr_gt0 // subr_gt0.
have sA b1 b2 b3 : D (A x) (A y) (A z) b1 b2 b3 = \sum_(0 <= a < i) D (f a x) (f a y) (f a z) b1 b2 b3.
  rewrite (eq_bigr (fun a => f a x * (f i y * b3 - b2 * f i z) + f a y * (b1 * f i z - f i x * b3) + f a z * (f i x * b2 - b1 * f i y))).
    by rewrite !big_split /= -!mulr_suml -/(A x) -/(A y) -/(A z) /D; ring.
  by move=> a _; rewrite /D; ring.
have sB a1 a2 a3 : D a1 a2 a3 (B x) (B y) (B z) = \sum_(i.+1 <= b < n.+1) D a1 a2 a3 (f b x) (f b y) (f b z).
  rewrite (eq_bigr (fun b => f b x * (a2 * f i z - f i y * a3) + f b y * (f i x * a3 - a1 * f i z) + f b z * (a1 * f i y - f i x * a2))).
    by rewrite !big_split /= -!mulr_suml -/(B x) -/(B y) -/(B z) /D; ring.
  by move=> b _; rewrite /D; ring.
rewrite sA in neg; have [a /andP[_ ai] na] := sum_lt0 neg.
rewrite sB in na; have [b /andP[ib bn] nb] := sum_lt0 na.
exists a, b; rewrite ai ib; split=> //; split=> //.
rewrite (det3 (fun p q => f (nth 0%N [:: a; i; b] q) (nth 0 [:: x; y; z] p))) /=.
by move: nb; rewrite /D; apply: le_lt_trans; rewrite le_eqVlt; apply/orP; left; apply/eqP; ring.
Qed.
End Minor.

(* X.totalpositivity is false for every k >= 3 and every r <> 1: U open, inner multiplicities at most k, three functions and three
   points of [t_0,t_m] with a negative minor *)
Theorem X_totalpositivity_printed_false (R : realFieldType) (r : R) k : 0 < r -> r != 1 -> (3 <= k)%N ->
  exists n (t : nat -> R) (a b c : nat) (x y z : R), [/\ forall i, t i <= t i.+1, Uopen t n k, Uinner t n k & [/\ (a < b < c)%N, (c <= n)%N,
    t 0%N <= x, x < y & [/\ y < z, z <= t (n + k.+1)%N &
    \det (\matrix_(p < 3, q < 3) value r t (n + k.+1) k (nth 0%N [:: a; b; c] q) (nth 0 [:: x; y; z] p)) < 0]]].
Proof.
move=> r0 r1 k3; have [t [x1 [x2 [x3 /= [tm ho hi [h1 h2 h3 h4 [g1 g2 _ _]]]]]]] := open_two_maxima r0 r1 k3.
have kn : (k <= k.*2)%N by rewrite -addnn leq_addr.
have [a [b [ab [bn neg]]]] := negative_minor r0 tm kn ho (ltW h1) h2 h3 (ltW h4) g1 g2.
by exists k.*2, t, a, k, b, x1, x2, x3; rewrite (ltW h1) (ltW h4).
Qed.
