(* One-sided derivatives: L3.8 to L3.10, T3.11.2, T3.11.3, P4.2.2, P3.1.2 as a limit.
   dN is the product rule along the recursion; "taylor" ties it to the function: f(x+h) = v + l h + h^2 g(h), g bounded near 0. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Algebra.
Variable R : comRingType.
Implicit Types w dw : nat -> nat -> R.

Fixpoint dN w dw (s k i : nat) : R :=
  if k is d.+1 then (dw d.+1 i * N w s d i + w d.+1 i * dN w dw s d i)
                  + (- dw d.+1 i.+1 * N w s d i.+1 + (1 - w d.+1 i.+1) * dN w dw s d i.+1)
  else 0.
Lemma dNS w dw s d i : dN w dw s d.+1 i = (dw d.+1 i * N w s d i + w d.+1 i * dN w dw s d i)
   + (- dw d.+1 i.+1 * N w s d i.+1 + (1 - w d.+1 i.+1) * dN w dw s d i.+1).
Proof. by []. Qed.
Lemma dN_supp w dw s k i : ~~ (i <= s <= i + k)%N -> dN w dw s k i = 0.
Proof.
elim: k i => [|k IH] i h //; rewrite dNS !IH ?N_supp ?mulr0 ?addr0 //; apply: contra h; lia.
Qed.

(* at the left end of the support every weight that matters is 0 *)
Section Start.
Variables (w dw : nat -> nat -> R) (s : nat).
Hypothesis w0 : forall e j, (j <= s < j + e)%N -> w e j = 0.
Lemma N_start d i : N w s d i = (i + d == s)%N%:R.
Proof.
elim: d i => [|d IH] i; first by rewrite addn0.
rewrite NS !IH addSnnS; case: (eqVneq (i + d.+1)%N s) => e.
  have -> : (i + d == s)%N = false by apply/eqP; lia.
  by rewrite mulr0 add0r w0 ?subr0 ?mul1r //; lia.
rewrite mulr0 addr0; case: (eqVneq (i + d)%N s) => e2; last by rewrite mulr0.
by rewrite w0 ?mul0r //; lia.
Qed.
(* L3.8, all three lines at once *)
Lemma dN_start_step d i : dN w dw s d.+1 i =
  dN w dw s d i.+1 + ((i + d == s)%N%:R * dw d.+1 i - (i.+1 + d == s)%N%:R * dw d.+1 i.+1).
Proof.
rewrite dNS !N_start.
have -> : w d.+1 i * dN w dw s d i = 0.
  by case: (boolP (i <= s <= i + d)%N) => e; [rewrite w0 ?mul0r //; lia|rewrite dN_supp ?mulr0].
have -> : (1 - w d.+1 i.+1) * dN w dw s d i.+1 = dN w dw s d i.+1.
  case: (boolP (i.+1 <= s <= i.+1 + d)%N) => e; last by rewrite dN_supp ?mulr0.
  by rewrite w0 ?subr0 ?mul1r //; lia.
by rewrite addr0; ring.
Qed.
(* the derivatives where all weights are 0 *)
Theorem dN_start d i : dN w dw s d i =
  ((i + d == s.+1)%N%:R - (i + d == s)%N%:R) * \sum_(1 <= e < d.+1) dw e (s.+1 - e)%N.
Proof.
elim: d i => [|d IH] i; first by rewrite big_geq // mulr0.
rewrite dN_start_step IH [in RHS]big_nat_recr // !addSnnS mulrDr; congr (_ + _).
have -> : (i + d.+1 == s.+1)%N = (i + d == s)%N by rewrite addnS eqSS.
rewrite mulrBl; congr (_ - _).
  by case: (eqVneq (i + d)%N s) => e; rewrite ?mul0r // -e subSS addnK.
case: (eqVneq (i + d.+1)%N s) => e; rewrite ?mul0r //.
by have -> : (s.+1 - d.+1 = i.+1)%N by lia.
Qed.
End Start.

(* at the right end t_m every weight that matters is 1 (indices of the basis 0..m) *)
Section Stop.
Variables (w dw : nat -> nat -> R) (s m : nat).
Hypothesis w1 : forall e j, (j <= s < j + e)%N -> (j + e <= m)%N -> w e j = 1.
Lemma N_stop d i : (i + d < m)%N -> N w s d i = (i == s)%:R.
Proof.
elim: d i => [|d IH] i im //; rewrite NS !IH; try lia.
have -> : w d.+1 i * (i == s)%:R = (i == s)%:R.
  by case: (eqVneq i s) => e; [rewrite w1 ?mul1r //; lia|rewrite mulr0].
case: (eqVneq i.+1 s) => e; last by rewrite mulr0 addr0.
rewrite -e; case: (posnP d) => d0; last by rewrite w1 ?subrr ?mul0r ?addr0 //; lia.
by rewrite d0 w1 ?subrr ?mul0r ?addr0 //; lia.
Qed.
(* L3.9, L3.10 *)
Lemma dN_stop_step d i : (i + d.+1 < m)%N -> dN w dw s d.+1 i =
  dN w dw s d i + ((i == s)%:R * dw d.+1 i - (i.+1 == s)%:R * dw d.+1 i.+1).
Proof.
move=> im; rewrite dNS !N_stop; try lia.
have -> : w d.+1 i * dN w dw s d i = dN w dw s d i.
  by case: (boolP (i <= s <= i + d)%N) => e; [rewrite w1 ?mul1r //; lia|rewrite dN_supp ?mulr0].
have -> : (1 - w d.+1 i.+1) * dN w dw s d i.+1 = 0.
  case: (boolP (i.+1 <= s <= i.+1 + d)%N) => e; last by rewrite dN_supp ?mulr0.
  by rewrite w1 ?subrr ?mul0r //; lia.
by ring.
Qed.
(* the derivatives where all weights are 1 *)
Theorem dN_stop d i : (i + d < m)%N -> dN w dw s d i =
  ((i == s)%:R - (i.+1 == s)%:R) * \sum_(1 <= e < d.+1) dw e s.
Proof.
elim: d i => [|d IH] i im; first by rewrite big_geq // mulr0.
rewrite dN_stop_step // IH; last lia.
rewrite [in RHS]big_nat_recr // mulrDr; congr (_ + _); rewrite mulrBl.
by congr (_ - _); [case: (eqVneq i s) => [->|_]; rewrite ?mul0r|case: (eqVneq i.+1 s) => [->|_]; rewrite ?mul0r].
Qed.
End Stop.
End Algebra.

(* ---- what "derivative" means ---- *)
Section Taylor.
Variable R : realFieldType.
Implicit Types (f g : R -> R) (x v l h : R).
Definition bnd g := exists C d : R, [/\ 0 <= C, 0 < d & forall h, `|h| < d -> `|g h| <= C].
(* f(x+h) = v + l h + h^2 g(h) near h = 0 *)
Definition taylor f x v l := exists g d, [/\ bnd g, 0 < d & forall h, `|h| < d -> f (x + h) = v + l * h + h ^+ 2 * g h].

Lemma bnd_const c : bnd (fun _ => c).
Proof. by exists `|c|, 1; split => //; rewrite ?normr_ge0 ?ltr01. Qed.
Lemma bnd_id : bnd (fun h => h).
Proof. by exists 1, 1; split; rewrite ?ler01 ?ltr01 // => h /ltW. Qed.
Lemma bnd_add g1 g2 : bnd g1 -> bnd g2 -> bnd (fun h => g1 h + g2 h).
Proof.
move=> [C1 [d1 [c1 p1 h1]]] [C2 [d2 [c2 p2 h2]]]; exists (C1 + C2), (Num.min d1 d2); split.
- by rewrite addr_ge0.
- by rewrite lt_minr p1.
by move=> h; rewrite lt_minr => /andP[a1 a2]; apply: le_trans (ler_norm_add _ _) _; rewrite ler_add ?h1 ?h2.
Qed.
Lemma bnd_mul g1 g2 : bnd g1 -> bnd g2 -> bnd (fun h => g1 h * g2 h).
Proof.
move=> [C1 [d1 [c1 p1 h1]]] [C2 [d2 [c2 p2 h2]]]; exists (C1 * C2), (Num.min d1 d2); split.
- by rewrite mulr_ge0.
- by rewrite lt_minr p1.
by move=> h; rewrite lt_minr => /andP[a1 a2]; rewrite normrM ler_pmul ?normr_ge0 ?h1 ?h2.
Qed.
Lemma taylor_const c x : taylor (fun _ => c) x c 0.
Proof. by exists (fun _ => 0), 1; split; [exact: bnd_const|exact: ltr01|move=> h _; ring]. Qed.
Lemma taylor_add f g x v l v' l' : taylor f x v l -> taylor g x v' l' -> taylor (fun y => f y + g y) x (v + v') (l + l').
Proof.
move=> [p [d [b0 d0 h0]]] [q [e [b1 e0 h1]]]; exists (fun h => p h + q h), (Num.min d e); split.
- exact: bnd_add.
- by rewrite lt_minr d0.
by move=> h; rewrite lt_minr => /andP[a1 a2]; rewrite h0 // h1 //; ring.
Qed.
Lemma taylor_mul f g x v l v' l' : taylor f x v l -> taylor g x v' l' ->
  taylor (fun y => f y * g y) x (v * v') (l * v' + v * l').
Proof.
move=> [p [d [b0 d0 h0]]] [q [e [b1 e0 h1]]].
exists (fun h => l * l' + (v * q h + v' * p h) + h * (l * q h + l' * p h) + h * h * (p h * q h)), (Num.min d e); split.
- have bc := bnd_const; have bi := bnd_id.
  apply: bnd_add; first apply: bnd_add; first apply: bnd_add.
  + exact: bc.
  + by apply: bnd_add; apply: bnd_mul.
  + by apply: bnd_mul => //; apply: bnd_add; apply: bnd_mul.
  + by apply: bnd_mul; apply: bnd_mul.
- by rewrite lt_minr d0.
by move=> h; rewrite lt_minr => /andP[a1 a2]; rewrite h0 // h1 //; ring.
Qed.
Lemma taylor_1sub f x v l : taylor f x v l -> taylor (fun y => 1 - f y) x (1 - v) (- l).
Proof.
move=> [p [d [b0 d0 h0]]]; exists (fun h => (-1) * p h), d; split => //.
  by apply: bnd_mul => //; apply: bnd_const.
by move=> h a; rewrite h0 //; ring.
Qed.
Lemma taylor_ext f g x v l : (forall y, f y = g y) -> taylor f x v l -> taylor g x v l.
Proof. by move=> e [p [d [b d0 h0]]]; exists p, d; split => // h a; rewrite -e h0. Qed.

(* value and first-order coefficient are determined, even by one side (sg = 1 or -1) *)
Lemma small_zero (c K d : R) : 0 < d -> (forall h, 0 < h < d -> `|c| <= K * h) -> c = 0.
Proof.
move=> d0 H; apply/eqP; rewrite -normr_le0 leNgt; apply/negP => c0.
have K0 : 0 < `|K| + 1 by rewrite ltr_paddl.
set h := Num.min (d / 2%:R) (`|c| / (2%:R * (`|K| + 1))).
have two : 0 < 2%:R :> R by rewrite ltr0n.
have h0 : 0 < h by rewrite lt_minr !divr_gt0 // mulr_gt0.
have hd : h < d.
  rewrite lt_minl; apply/orP; left; rewrite ltr_pdivr_mulr // ltr_pmulr // ltr1n //.
have := H h; rewrite h0 hd => /(_ isT); rewrite leNgt; apply/negP; rewrite negbK.
have le : h <= `|c| / (2%:R * (`|K| + 1)) by rewrite le_minl lexx orbT.
apply: (@le_lt_trans _ _ ((`|K| + 1) * h)).
  by rewrite ler_pmul2r // (le_trans (ler_norm K)) // ler_addl ler01.
apply: (@le_lt_trans _ _ ((`|K| + 1) * (`|c| / (2%:R * (`|K| + 1))))); first by rewrite ler_pmul2l.
have -> : (`|K| + 1) * (`|c| / (2%:R * (`|K| + 1))) = `|c| / 2%:R by field; rewrite gt_eqF.
by rewrite ltr_pdivr_mulr // ltr_pmulr // ltr1n.
Qed.
End Taylor.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.

Definition dmob (r x a b : R) : R := r * (b - a) / (r * (x - a) + (b - x)) ^+ 2.
Lemma dmob_a a b : a < b -> dmob r a a b = r / (b - a).
Proof.
move=> ab; have e : b - a != 0 by rewrite gt_eqF ?subr_gt0.
have -> : r / (b - a) = r * (b - a) / (b - a) ^+ 2 by field.
by rewrite /dmob subrr mulr0 add0r.
Qed.
Lemma dmob_b a b : a < b -> dmob r b a b = r^-1 / (b - a).
Proof.
move=> ab; have e : b - a != 0 by rewrite gt_eqF ?subr_gt0.
have r1 : r != 0 by rewrite gt_eqF.
have -> : r^-1 / (b - a) = r * (b - a) / (r * (b - a)) ^+ 2 by field; rewrite ?e ?r1.
by rewrite /dmob subrr addr0.
Qed.
Lemma mob_taylor x a b : a <= x -> x <= b -> a < b -> taylor (fun y => mob r y a b) x (mob r x a b) (dmob r x a b).
Proof.
move=> ax xb ab; have D0 := mob_den_gt0 r_gt0 ax xb ab; set D := r * (x - a) + (b - x) in D0.
have two : 0 < 2%:R :> R by rewrite ltr0n.
have q0 : 0 < `|r - 1| + 1 by rewrite ltr_paddl.
have key h : `|h| < D / (2%:R * (`|r - 1| + 1)) -> D / 2%:R <= D + (r - 1) * h.
  move=> hh; have : `|(r - 1) * h| <= D / 2%:R.
    rewrite normrM; apply: (@le_trans _ _ ((`|r - 1| + 1) * (D / (2%:R * (`|r - 1| + 1))))).
      by rewrite ler_pmul ?normr_ge0 ?ler_addl ?ler01 // ltW.
    by rewrite le_eqVlt; apply/orP; left; apply/eqP; field; rewrite gt_eqF.
  rewrite ler_norml => /andP[h1 _].
  have -> : D / 2%:R = D - D / 2%:R by field.
  by rewrite ler_add2l.
exists (fun h => - (r * (r - 1) * (b - a) / D ^+ 2) * (D + (r - 1) * h)^-1), (D / (2%:R * (`|r - 1| + 1))).
split; last 1 first.
- move=> h hh; have Dh : 0 < D + (r - 1) * h by apply: lt_le_trans (key _ hh); rewrite divr_gt0.
  rewrite /mob /dmob -/D; have -> : r * (x + h - a) + (b - (x + h)) = D + (r - 1) * h by rewrite /D; ring.
  have e1 : D != 0 by rewrite gt_eqF. have e2 : D + (r - 1) * h != 0 by rewrite gt_eqF.
  have -> : b - a = (D - (r - 1) * (x - a)) by rewrite /D; ring.
  by field; rewrite e1 e2.
- apply: bnd_mul; first exact: bnd_const.
  exists (2%:R / D), (D / (2%:R * (`|r - 1| + 1))); split.
  + by rewrite ltW // divr_gt0.
  + by rewrite divr_gt0 // mulr_gt0.
  move=> h hh; have Dh : 0 < D + (r - 1) * h by apply: lt_le_trans (key _ hh); rewrite divr_gt0.
  rewrite gtr0_norm ?invr_gt0 // -[2%:R / D]invrK invf_div lef_pinv ?posrE ?divr_gt0 //.
  exact: key.
- by rewrite divr_gt0 // mulr_gt0.
Qed.

Definition dmw d i x := dmob r x (t i) (t (i + d)%N).
Definition dP s k i x : R := dN (fun d j => mw r t d j x) (fun d j => dmw d j x) s k i.

(* the piece of a span has value P and first-order coefficient dP at every x of the closed span *)
Theorem P_taylor s k i x : t s < t s.+1 -> t s <= x <= t s.+1 -> taylor (P r t s k i) x (P r t s k i x) (dP s k i x).
Proof.
move=> ss /andP[x1 x2].
have W d j : (j <= s < j + d)%N -> taylor (mw r t d j) x (mw r t d j x) (dmw d j x).
  move=> /andP[h1 h2]; apply: mob_taylor.
  - exact: le_trans (tle h1) x1.
  - exact: le_trans x2 (tle h2).
  - exact: (le_lt_trans (tle h1) (lt_le_trans ss (tle h2))).
elim: k i => [|k IH] i; first exact: taylor_const.
rewrite /dP /P /piece dNS NS; apply: (@taylor_ext _ (fun y => mw r t k.+1 i y * P r t s k i y + (1 - mw r t k.+1 i.+1 y) * P r t s k i.+1 y)) => //.
apply: taylor_add.
  case: (boolP (i <= s <= i + k)%N) => e; first by apply: taylor_mul; [apply: W; lia|exact: IH].
  rewrite N_supp // dN_supp // !mulr0 addr0; apply: (@taylor_ext _ (fun _ => 0)); last exact: taylor_const.
  by move=> y; rewrite /P /piece N_supp // mulr0.
case: (boolP (i.+1 <= s <= i.+1 + k)%N) => e.
  apply: taylor_mul; last exact: IH.
  by apply: taylor_1sub; apply: W; lia.
rewrite N_supp // dN_supp // !mulr0 addr0; apply: (@taylor_ext _ (fun _ => 0)); last exact: taylor_const.
by move=> y; rewrite /P /piece N_supp // mulr0.
Qed.

(* one-sided expansions of G itself *)
Definition right_taylor (f : R -> R) x v l :=
  exists g d, [/\ bnd g, 0 < d & forall h, 0 <= h < d -> f (x + h) = v + l * h + h ^+ 2 * g h].
Definition left_taylor (f : R -> R) x v l :=
  exists g d, [/\ bnd g, 0 < d & forall h, 0 < h < d -> f (x - h) = v - l * h + h ^+ 2 * g h].

(* the expansion of G to the right *)
Theorem G_right s k i x : t s <= x < t s.+1 -> right_taylor (G (wt r t) t k i) x (P r t s k i x) (dP s k i x).
Proof.
move=> /andP[x1 x2]; have [||g [d [bg d0 hg]]] := @P_taylor s k i x.
- exact: le_lt_trans x2.
- by rewrite x1 ltW.
exists g, (Num.min d (t s.+1 - x)); split => //; first by rewrite lt_minr d0 subr_gt0.
move=> h /andP[h0]; rewrite lt_minr => /andP[h1 h2].
rewrite (@G_P _ r t t_mono s); last by rewrite (le_trans x1) ?ler_addl //= addrC -ltr_subr_addr.
by rewrite hg // ger0_norm.
Qed.
(* the expansion of G to the left *)
Theorem G_left s k i x : t s < x <= t s.+1 -> left_taylor (G (wt r t) t k i) x (P r t s k i x) (dP s k i x).
Proof.
move=> /andP[x1 x2]; have [||g [d [bg d0 hg]]] := @P_taylor s k i x.
- exact: lt_le_trans x2.
- by rewrite x2 ltW.
exists (fun h => g (- h)), (Num.min d (x - t s)); split => //; last 1 first.
- move=> h /andP[h0]; rewrite lt_minr => /andP[h1 h2].
  rewrite (@G_P _ r t t_mono s); last first.
    by rewrite ler_subr_addr addrC -ler_subr_addr (ltW h2) /= (lt_le_trans _ x2) // ltr_subl_addr ltr_addl.
  by rewrite hg ?normrN ?ger0_norm ?(ltW h0) // sqrrN mulrN.
- by case: bg => C [e [c0 e0 H]]; exists C, e; split => // h hh; apply: H; rewrite normrN.
- by rewrite lt_minr d0 subr_gt0.
Qed.

(* T3.11.3a as amended; L3.8 is dN_start_step *)
Theorem T3_11_3a_value k i : t 0%N = t k -> t k < t k.+1 ->
  dP k k i (t 0%N) = ((i == 1%N)%:R - (i == 0%N)%:R) * (k%:R * (r / (t k.+1 - t 0%N))).
Proof.
move=> e0 h; have ej j : (j <= k)%N -> t j = t 0%N.
  by move=> jk; apply/eqP; rewrite eq_le {1}e0 !tle.
rewrite /dP dN_start; last first.
  by move=> e j /andP[j1 _]; rewrite /mw -(ej j) // mob_a.
rewrite -addn1 [(k + 1)%N]addnC !eqn_add2r -[X in (i + k == X)%N]add0n eqn_add2r; congr (_ * _).
rewrite (eq_big_nat _ _ (F2 := fun _ => r / (t k.+1 - t 0%N))).
  by rewrite sumr_const_nat subSS subn0 mulr_natl.
move=> e /andP[e1 e2]; rewrite /dmw -{1}(ej (1 + k - e)%N); last lia.
have -> : (1 + k - e + e = k.+1)%N by lia.
by rewrite (ej (1 + k - e)%N) ?dmob_a // ?e0 //; lia.
Qed.
(* T3.11.3a as expansions of the functions *)
Theorem T3_11_3a k : (0 < k)%N -> t 0%N = t k -> t k < t k.+1 ->
  let c := k%:R * (r / (t k.+1 - t 0%N)) in
  [/\ right_taylor (G (wt r t) t k 0) (t 0%N) 1 (- c), right_taylor (G (wt r t) t k 1) (t 0%N) 0 c &
      forall i, (2 <= i)%N -> right_taylor (G (wt r t) t k i) (t 0%N) 0 0].
Proof.
move=> k0 e0 h c.
have H i : right_taylor (G (wt r t) t k i) (t 0%N) (i == 0%N)%:R (((i == 1%N)%:R - (i == 0%N)%:R) * c).
  rewrite -(@T3_11_3a_value k i) // -(@P3_1_3_left _ (wt r t) t t_mono k i) //; last exact: wt_left.
  rewrite (@G_P _ r t t_mono k); last by rewrite -e0 lexx e0.
  by apply: G_right; rewrite e0 lexx.
split; first by have := H 0%N; rewrite /= sub0r mulN1r.
  by have := H 1%N; rewrite /= subr0 mul1r.
by move=> [|[|i]] // _; have := H i.+2; rewrite /= subr0 mul0r.
Qed.

(* T3.11.3b, all indices at once *)
Theorem T3_11_3b_value k n i : t n < t n.+1 -> t n.+1 = t (n + k.+1)%N -> (i <= n)%N ->
  dP n k i (t (n + k.+1)%N) = ((i == n)%:R - (i.+1 == n)%:R) * (k%:R * (r^-1 / (t (n + k.+1)%N - t n))).
Proof.
move=> h e0 im; set m := (n + k.+1)%N in e0 *.
have ej j : (n < j <= m)%N -> t j = t m.
  by move=> /andP[j1 j2]; apply/eqP; rewrite eq_le tle // -e0 tle.
rewrite /dP (@dN_stop _ _ _ _ m); last first.
- rewrite /m; lia.
- move=> e j h1 h2; rewrite /mw -(ej (j + e)%N); last lia.
  rewrite mob_b // (ej (j + e)%N); last lia.
  by rewrite -e0 (le_lt_trans _ h) // tle //; lia.
congr (_ * _); rewrite (eq_big_nat _ _ (F2 := fun _ => r^-1 / (t m - t n))).
  by rewrite sumr_const_nat subSS subn0 mulr_natl.
move=> e /andP[e1 e2]; rewrite /dmw -(ej (n + e)%N); last by rewrite /m; lia.
rewrite dmob_b // (ej (n + e)%N) -?e0 //; rewrite /m; lia.
Qed.
(* T3.11.3b as expansions of the functions *)
Theorem T3_11_3b k n : (0 < k)%N -> (0 < n)%N -> t n < t n.+1 -> t n.+1 = t (n + k.+1)%N ->
  let m := (n + k.+1)%N in let c := k%:R * (r^-1 / (t m - t n)) in
  [/\ left_taylor (G (wt r t) t k n) (t m) 1 c, left_taylor (G (wt r t) t k n.-1) (t m) 0 (- c) &
      forall i, (i.+2 <= n)%N -> left_taylor (G (wt r t) t k i) (t m) 0 0].
Proof.
move=> k0 n0 h e0 m c.
have H i : (i <= n)%N -> left_taylor (G (wt r t) t k i) (t m) (i == n)%:R (((i == n)%:R - (i.+1 == n)%:R) * c).
  move=> im; rewrite -(@T3_11_3b_value k n i) //.
  rewrite -(@P3_1_3_right _ (mw r t) t t_mono _ k n i) //; last exact: mw_right.
  by apply: G_left; rewrite -/m -e0 h lexx.
split.
- have := H n (leqnn n); rewrite eqxx; have -> : (n.+1 == n) = false by apply/eqP; lia.
  by rewrite subr0 mul1r.
- have := H n.-1 (leq_pred n); rewrite prednK // eqxx; have -> : (n.-1 == n) = false by apply/eqP; lia.
  by rewrite sub0r mulN1r.
move=> i i2; have := H i; have -> : (i == n) = false by apply/eqP; lia.
have -> : (i.+1 == n) = false by apply/eqP; lia.
by rewrite subr0 mul0r; apply; lia.
Qed.

(* T3.11.2: one-sided expansions at every x of [t_0,t_m), any knots *)
Theorem T3_11_2_right m k i x : t 0%N <= x < t m -> exists v l, right_taylor (G (wt r t) t k i) x v l.
Proof.
by move=> h; have [s [_ hs]] := span_exists t_mono h; exists (P r t s k i x), (dP s k i x); apply: G_right.
Qed.
End Paper.

(* in the paper's index: r = al/(al-1), 1/r = (al-1)/al *)
Lemma T3_11_3_alpha (R : realFieldType) (al d : R) (k : nat) : al < 0 \/ 1 < al ->
  k%:R * (al / (al - 1) / d) = k%:R * al / ((al - 1) * d) /\
  k%:R * ((al / (al - 1))^-1 / d) = (al - 1) * k%:R / (al * d).
Proof.
move=> h; rewrite invf_div !invfM !mulrA; split => //; by rewrite [(al - 1) * _]mulrC.
Qed.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.

(* ---- one-sided expansions determine value and first coefficient ---- *)
Lemma expansion_unique (v l : R) (g : R -> R) d : 0 < d -> bnd g ->
  (forall h, 0 < h < d -> v + l * h + h ^+ 2 * g h = 0) -> v = 0 /\ l = 0.
Proof.
move=> d0 [C [d1 [C0 d10 gC]]] H.
have v0 : v = 0.
  apply: (@small_zero _ v (`|l| + C) (Num.min 1 (Num.min d d1))); first by rewrite !lt_minr ltr01 d0.
  move=> h; rewrite !lt_minr => /andP[h0 /and3P[h1 h2 h3]].
  have -> : v = - (h * (l + h * g h)).
    by apply/eqP; rewrite -subr_eq0 opprK -[X in _ == X](H h) ?h0 //; apply/eqP; ring.
  rewrite normrN normrM gtr0_norm // [h * `|_|]mulrC ler_pmul2r //.
  apply: le_trans (ler_norm_add _ _) _; rewrite ler_add2l normrM gtr0_norm //.
  rewrite -[X in _ <= X]mul1r ler_pmul ?normr_ge0 ?(ltW h0) ?(ltW h1) // gC // gtr0_norm //.
split => //; apply: (@small_zero _ l C (Num.min d d1)); first by rewrite lt_minr d0.
move=> h; rewrite lt_minr => /andP[h0 /andP[h2 h3]].
have hn : h != 0 by rewrite gt_eqF.
have -> : l = - (h * g h).
  apply: (mulfI hn); apply/eqP; rewrite -subr_eq0 -[X in _ == X](H h) ?h0 // v0; apply/eqP; ring.
by rewrite normrN normrM gtr0_norm // [h * `|_|]mulrC ler_pmul2r // gC // gtr0_norm.
Qed.
Lemma bnd_opp (g : R -> R) : bnd g -> bnd (fun h => - g h).
Proof. by case=> C [d [c0 d0 H]]; exists C, d; split => // h hh; rewrite normrN H. Qed.
(* an expansion to the right has one value and one first coefficient only *)
Theorem right_taylor_unique (f : R -> R) x v l v' l' : right_taylor f x v l -> right_taylor f x v' l' -> v = v' /\ l = l'.
Proof.
move=> [g [d [bg d0 h0]]] [g' [d' [bg' d0' h0']]].
have [||h a|e1 e2] := @expansion_unique (v - v') (l - l') (fun h => g h + - g' h) (Num.min d d').
- by rewrite lt_minr d0.
- by apply: bnd_add => //; apply: bnd_opp.
- case/andP: a => a; rewrite lt_minr => /andP[a1 a2].
  transitivity (f (x + h) - f (x + h)); last by rewrite subrr.
  by rewrite {1}h0 ?(ltW a) // h0' ?(ltW a) //; ring.
by split; apply/eqP; rewrite -subr_eq0 ?e1 ?e2.
Qed.
(* and so has one to the left *)
Theorem left_taylor_unique (f : R -> R) x v l v' l' : left_taylor f x v l -> left_taylor f x v' l' -> v = v' /\ l = l'.
Proof.
move=> [g [d [bg d0 h0]]] [g' [d' [bg' d0' h0']]].
have [||h a|e1 e2] := @expansion_unique (v - v') (l' - l) (fun h => g h + - g' h) (Num.min d d').
- by rewrite lt_minr d0.
- by apply: bnd_add => //; apply: bnd_opp.
- case/andP: a => a; rewrite lt_minr => /andP[a1 a2].
  transitivity (f (x - h) - f (x - h)); last by rewrite subrr.
  by rewrite {1}h0 ?a // h0' ?a //; ring.
by split; apply/eqP; [rewrite -subr_eq0 e1|rewrite eq_sym -subr_eq0 e2].
Qed.

(* ---- P3.1.2 as continuity: both limits are the value (with first-order expansions on both sides) ---- *)
Theorem P3_1_2_limits m k i y : t 0%N < y < t m -> (mult t m y <= k)%N ->
  exists l l', left_taylor (G (wt r t) t k i) y (G (wt r t) t k i y) l /\
               right_taylor (G (wt r t) t k i) y (G (wt r t) t k i y) l'.
Proof.
move=> hy hk; have [p [p1 p2 pm e]] := P3_1_2_paper r_gt0 t_mono i hy hk.
exists (dP r t p k i y); rewrite {1}e.
have [s [_ hs]] : exists s, (0 <= s < m)%N /\ t s <= y < t s.+1.
  by apply: span_exists => //; case/andP: hy => /ltW -> ->.
exists (dP r t s k i y); split; first by apply: G_left => //; rewrite p1.
by rewrite (G_P r t_mono _ _ hs); apply: G_right.
Qed.
(* epsilon-delta: a function with such expansions is continuous at y *)
Lemma taylor_continuous (f : R -> R) y l l' : left_taylor f y (f y) l -> right_taylor f y (f y) l' ->
  forall eps, 0 < eps -> exists2 d, 0 < d & forall x, `|x - y| < d -> `|f x - f y| < eps.
Proof.
have half (g : R -> R) v a d : bnd g -> 0 < d -> exists K d', [/\ 0 < K, 0 < d', d' <= d &
    forall h, 0 <= h < d' -> `|v + a * h + h ^+ 2 * g h - v| <= K * h].
  move=> [C [d1 [C0 d10 gC]]] d0; exists (`|a| + C + 1), (Num.min 1 (Num.min d d1)); split.
  - by rewrite ltr_paddl ?ltr01 // addr_ge0.
  - by rewrite !lt_minr ltr01 d0.
  - by rewrite !le_minl lexx !orbT.
  move=> h; rewrite !lt_minr => /andP[h0 /and3P[h1 h2 h3]].
  have -> : v + a * h + h ^+ 2 * g h - v = (a + h * g h) * h by ring.
  rewrite normrM [`|h|]ger0_norm // ler_wpmul2r // (le_trans (ler_norm_add _ _)) //.
  rewrite -addrA ler_add2l normrM (ger0_norm h0) (@le_trans _ _ (1 * C)) //; last by rewrite mul1r ler_addl ler01.
  by rewrite ler_pmul // ?(ltW h1) // gC // ger0_norm.
move=> [g [d [bg d0 hg]]] [g' [d' [bg' d0' hg']]] eps e0.
have [K [q [K0 q0 qd HK]]] := half g (f y) (- l) d bg d0.
have [K' [q' [K0' q0' qd' HK']]] := half g' (f y) l' d' bg' d0'.
exists (Num.min (Num.min q q') (Num.min (eps / K) (eps / K'))).
  by rewrite !lt_minr q0 q0' !divr_gt0.
move=> x; rewrite !lt_minr => /andP[/andP[a1 a2] /andP[a3 a4]].
case: (leP y x) => xy.
  rewrite ger0_norm ?subr_ge0 // in a1 a2 a3 a4.
  have -> : x = y + (x - y) by ring.
  rewrite hg' ?subr_ge0 ?xy ?(lt_le_trans a2) //.
  by rewrite (le_lt_trans (HK' _ _)) ?subr_ge0 ?xy // mulrC -ltr_pdivl_mulr.
have xy' : `|x - y| = y - x by rewrite ltr0_norm ?subr_lt0 // opprB.
rewrite xy' in a1 a2 a3 a4.
have -> : x = y - (y - x) by ring.
rewrite hg ?subr_gt0 ?xy ?(lt_le_trans a1) // -mulNr.
by rewrite (le_lt_trans (HK _ _)) ?subr_ge0 ?(ltW xy) // mulrC -ltr_pdivl_mulr.
Qed.
(* continuity in the usual sense *)
Theorem P3_1_2_continuous m k i y : t 0%N < y < t m -> (mult t m y <= k)%N ->
  forall eps, 0 < eps -> exists2 d, 0 < d & forall x, `|x - y| < d -> `|G (wt r t) t k i x - G (wt r t) t k i y| < eps.
Proof.
move=> hy hk; have [l [l' [h1 h2]]] := P3_1_2_limits i hy hk; exact: taylor_continuous h1 h2.
Qed.

(* ---- P4.2.2 ---- *)
Variable V : lmodType R.
(* the derivatives at t_0, summed up with the control points *)
Theorem P4_2_2_left k n (d : nat -> V) : (0 < k)%N -> (0 < n)%N -> t 0%N = t k -> t k < t k.+1 ->
  \sum_(0 <= i < n.+1) dP r t k k i (t 0%N) *: d i = (k%:R * (r / (t k.+1 - t 0%N))) *: (d 1%N - d 0%N).
Proof.
move=> k0 n0 e0 h; case: n n0 => // n _; rewrite big_nat_recl // big_nat_recl // !T3_11_3a_value //=.
rewrite big1 ?addr0; last by move=> i _; rewrite T3_11_3a_value //= subr0 mul0r scale0r.
by rewrite sub0r subr0 mulN1r mul1r scalerBr scaleNr addrC.
Qed.
(* the derivatives at t_m, summed up with the control points *)
Theorem P4_2_2_right k n (d : nat -> V) : (0 < k)%N -> (0 < n)%N -> t n < t n.+1 -> t n.+1 = t (n + k.+1)%N ->
  \sum_(0 <= i < n.+1) dP r t n k i (t (n + k.+1)%N) *: d i =
  (k%:R * (r^-1 / (t (n + k.+1)%N - t n))) *: (d n - d n.-1).
Proof.
move=> k0 n0 h e0; case: n n0 h e0 => // n _ h e0; rewrite big_nat_recr // big_nat_recr //=.
rewrite big_nat_cond big1 ?add0r; last first.
  move=> i hi; rewrite T3_11_3b_value //; last lia.
  have -> : (i == n.+1) = false by apply/eqP; lia.
  have -> : (i.+1 == n.+1) = false by apply/eqP; lia.
  by rewrite subr0 mul0r scale0r.
rewrite !T3_11_3b_value // !eqxx.
have -> : (n == n.+1) = false by apply/eqP; lia.
have -> : (n.+2 == n.+1) = false by apply/eqP; lia.
by rewrite sub0r subr0 mulN1r mul1r scalerBr scaleNr addrC.
Qed.
End Paper.

(* the sums above are the derivatives of the curve, coordinate by coordinate (V = R) *)
Section Coordinate.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Lemma sum_right (f : nat -> R -> R) (v l d : nat -> R) n x : (forall i, (i < n)%N -> right_taylor (f i) x (v i) (l i)) ->
  right_taylor (fun y => \sum_(0 <= i < n) f i y * d i) x (\sum_(0 <= i < n) v i * d i) (\sum_(0 <= i < n) l i * d i).
Proof.
elim: n => [|n IH] H.
  exists (fun _ => 0), 1; split; [exact: bnd_const|exact: ltr01|move=> h _; rewrite !big_geq //; ring].
have [|g [e [bg e0 hg]]] := IH; first by move=> i hi; apply: H; apply: leqW.
have [p [q [bp q0 hp]]] := H n (ltnSn n).
exists (fun h => g h + p h * d n), (Num.min e q); split.
- by apply: bnd_add => //; apply: bnd_mul => //; apply: bnd_const.
- by rewrite lt_minr e0.
move=> h /andP[h0]; rewrite lt_minr => /andP[h1 h2].
rewrite ![\sum_(0 <= i < n.+1) _]big_nat_recr //= hg ?h0 // hp ?h0 //.
move: (\sum_(0 <= i < n) v i * d i) (\sum_(0 <= i < n) l i * d i) => A A'.
move: (v n) (l n) (d n) (g h) (p h) => B B' c u u'; ring.
Qed.
(* the expansion of the curve at t_0, one coordinate *)
Theorem P4_2_2_curve_left k n (d : nat -> R^o) : (0 < k)%N -> (0 < n)%N -> t 0%N = t k -> t k < t k.+1 ->
  right_taylor (curve (wt r t) t k n d) (t 0%N) (d 0%N) (k%:R * (r / (t k.+1 - t 0%N)) * (d 1%N - d 0%N)).
Proof.
move=> k0 n0 e0 h; have := @sum_right (fun i => G (wt r t) t k i) (fun i => P r t k k i (t 0%N)) (fun i => dP r t k k i (t 0%N)) d n.+1 (t 0%N).
have -> : \sum_(0 <= i < n.+1) dP r t k k i (t 0%N) * d i = k%:R * (r / (t k.+1 - t 0%N)) * (d 1%N - d 0%N).
  exact: (@P4_2_2_left R r r_gt0 t t_mono [lmodType R of R^o] k n d k0 n0 e0 h).
have -> : \sum_(0 <= i < n.+1) P r t k k i (t 0%N) * d i = d 0%N.
  rewrite -[RHS](@P4_2_1_left R (wt r t) t t_mono [lmodType R of R^o] k n d (wt_left r t) e0 h).
  by apply: eq_bigr => i _; rewrite (@G_P _ r t t_mono k) // e0 lexx.
by apply => i _; apply: G_right => //; rewrite e0 lexx.
Qed.
End Coordinate.
