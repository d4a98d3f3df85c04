(* The shape of curves: their total variation and length are at most those of the polygon, their derivative is a combination of the legs
   with factors that are not negative, so that T_j = G_j + .. + G_n rises strictly inside of a span; curves rise with r where the control values
   do; G_j/G_i does not fall for i < j; a level is crossed once where the control values cross it once. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis StatementsDerivatives StatementsCurves.
From Bsplines Require Import Cumulative Minors Terms.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* partial summation, with points *)
Lemma abel_points (R : ringType) (V : lmodType R) (g : nat -> R) (d : nat -> V) n :
  \sum_(0 <= i < n.+1) g i *: d i =
  (\sum_(0 <= i < n.+1) g i) *: d 0%N + \sum_(1 <= i < n.+1) (\sum_(i <= j < n.+1) g j) *: (d i - d i.-1).
Proof.
elim: n => [|n IH]; first by rewrite !big_nat1 big_geq // addr0.
rewrite big_nat_recr //= IH [in RHS]big_nat_recr //= [X in _ = _ + X]big_nat_recr //= big_nat1.
rewrite [X in _ = _ + (X + _)](eq_big_nat _ _ (F2 := fun i => (\sum_(i <= j < n.+1) g j) *: (d i - d i.-1) + g n.+1 *: (d i - d i.-1))); last first.
  by move=> i /andP[_ hi]; rewrite big_nat_recr /= ?scalerDl // ltnW.
rewrite big_split /= scalerDl -!addrA; congr (_ + _).
rewrite [in RHS]addrCA; congr (_ + _); rewrite -scaler_sumr -!scalerDr; congr (_ *: _).
rewrite big_add1 /= [\sum_(0 <= i < n) _]telescope_sumr //.
by rewrite addrCA addrA subrK addrC subrK.
Qed.

(* ---- the derivatives of the T_i, along their recursion ---- *)
Section Slopes.
Variable R : comRingType.
Variables (w dw : nat -> nat -> R) (s : nat).
Fixpoint dT (d i : nat) : R := if d is e.+1 then dw d i * N w s e i + (w d i * dT e i + (1 - w d i) * dT e i.+1) else 0.
Lemma dTS d i : dT d.+1 i = dw d.+1 i * N w s d i + (w d.+1 i * dT d i + (1 - w d.+1 i) * dT d i.+1). Proof. by []. Qed.
Lemma dN_dT d i : dN w dw s d i = dT d i - dT d i.+1.
Proof. by elim: d i => [|d IH] i; [rewrite /= subr0|rewrite dNS !IH !dTS; ring]. Qed.
Lemma dT_low d i : (i + d <= s)%N -> dT d i = 0.
Proof.
elim: d i => [|d IH] i h //; rewrite dTS N_supp ?IH ?mulr0 ?addr0 //; move: h; clear; lia.
Qed.
Lemma dT_high d i : (s < i)%N -> dT d i = 0.
Proof.
elim: d i => [|d IH] i h //; rewrite dTS N_supp ?IH ?mulr0 ?addr0 //; move: h; clear; lia.
Qed.
Lemma dT_sum d i b : (s < b)%N -> (i <= b)%N -> \sum_(i <= j < b) dN w dw s d j = dT d i.
Proof.
move=> sb ib; rewrite (eq_bigr (fun j => - (dT d j.+1 - dT d j))); last by move=> j _; rewrite dN_dT opprB.
by rewrite sumrN telescope_sumr // (dT_high _ sb) sub0r opprK.
Qed.
End Slopes.
Lemma dT_ge0 (R : realFieldType) (w dw : nat -> nat -> R) s d i : (forall e j, (j <= s < j + e)%N -> 0 <= w e j <= 1) ->
  (forall e j, (j <= s < j + e)%N -> 0 <= dw e j) -> 0 <= dT w dw s d i.
Proof.
move=> hw hd; elim: d i => [|d IH] i; first exact: lexx.
case: (boolP (i <= s < i + d.+1)%N) => h; last first.
  case: (leqP i s) => is_; last by rewrite dT_high.
  by rewrite dT_low //; move: h is_; clear; lia.
have /andP[a b] := hw _ _ h; rewrite dTS addr_ge0 ?mulr_ge0 ?hd ?N_ge0 //.
by rewrite addr_ge0 // mulr_ge0 ?subr_ge0.
Qed.
Lemma dT_gt0 (R : realFieldType) (w dw : nat -> nat -> R) s d i : (forall e j, (j <= s < j + e)%N -> 0 < w e j < 1) ->
  (forall e j, (j <= s < j + e)%N -> 0 < dw e j) -> (i <= s < i + d)%N -> 0 < dT w dw s d i.
Proof.
move=> hw hd; case: d => [|d] hi; first by move: hi; clear; lia.
have hw' e j : (j <= s < j + e)%N -> 0 <= w e j <= 1 by move=> h; have /andP[a b] := hw e j h; rewrite !ltW.
have /andP[a b] := hw _ _ hi; have p j : 0 <= dT w dw s d j by apply: dT_ge0 => // e l h; apply/ltW/hd.
rewrite dTS ltr_paddr //; first by rewrite addr_ge0 // mulr_ge0 ?subr_ge0 ?(ltW a) ?(ltW b).
by rewrite mulr_gt0 ?hd // N_gt0 //; move: hi; clear; lia.
Qed.

Section Shape.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Local Notation value := (value r t m).

Section Points.
Variable V : lmodType R.
(* D3.4, points of any vector space *)
Definition point (d : nat -> V) x : V := \sum_(0 <= i < n.+1) value k i x *: d i.
(* T_i on [t_0,t_m] *)
Definition Tv i x : R := \sum_(i <= j < n.+1) value k j x.
Lemma Tv_mono i x y : Uopen t n k -> (i <= n)%N -> t 0%N <= x -> x <= y -> y <= t m -> Tv i x <= Tv i y.
Proof.
move=> ho im x0 xy ym; have E z : Tv i z = coordinate r t n k (fun j => (i <= j)%N%:R) z.
  rewrite /coordinate (big_cat_nat _ (n := i)) ?leqW //= big_nat_cond big1 ?add0r; last first.
    by move=> j /andP[/andP[_ h] _]; rewrite leqNgt h mul0r.
  by apply: eq_big_nat => j /andP[h _]; rewrite h mul1r.
rewrite !E; apply: (monotone_curve t_mono r_gt0 ho) => // j _.
by rewrite ler_nat; case: (leqP i j) => h; rewrite ?leq0n // (leqW h).
Qed.
Lemma Tv_01 i x : Uopen t n k -> (i <= n)%N -> t 0%N <= x <= t m -> 0 <= Tv i x <= 1.
Proof.
move=> ho im hx; have [g0 g1] := P4_1_3_printed r_gt0 t_mono (Uopen_t0 ho) ho hx.
have p a b : (b <= n.+1)%N -> 0 <= \sum_(a <= j < b) value k j x.
  by move=> hb; rewrite big_nat_cond; apply: sumr_ge0 => j /andP[/andP[_ hj] _]; apply: g0; rewrite -ltnS (leq_trans hj).
by rewrite /Tv p //= -g1 [X in _ <= X](big_cat_nat _ (n := i)) ?leqW //= ler_addr p // leqW.
Qed.
Lemma point_abel d x : Uopen t n k -> t 0%N <= x <= t m -> point d x = d 0%N + \sum_(1 <= i < n.+1) Tv i x *: (d i - d i.-1).
Proof.
move=> ho hx; have [_ g1] := P4_1_3_printed r_gt0 t_mono (Uopen_t0 ho) ho hx.
by rewrite /point abel_points g1 scale1r.
Qed.
Lemma seq_le (x : nat -> R) b : (forall l, (l < b)%N -> x l <= x l.+1) -> forall i j, (i <= j <= b)%N -> x i <= x j.
Proof.
move=> h i j; elim: j => [|j IH] /andP[ij jb]; first by move: ij; rewrite leqn0 => /eqP ->.
move: ij; rewrite leq_eqVlt => /orP[/eqP ->|ij]; first exact: lexx.
by apply: le_trans (h j jb); apply: IH; rewrite -ltnS ij ltnW.
Qed.
(* X.length: the length of a curve, over any points x_0 <= .. <= x_b of the parameter and in any norm, is at most that of its polygon *)
Theorem length_curve (N : V -> R) d (x : nat -> R) b : (forall u v, N (u + v) <= N u + N v) -> (forall a u, N (a *: u) = `|a| * N u) ->
  Uopen t n k -> t 0%N <= x 0%N -> (forall l, (l < b)%N -> x l <= x l.+1) -> x b <= t m ->
  \sum_(0 <= l < b) N (point d (x l.+1) - point d (x l)) <= \sum_(1 <= i < n.+1) N (d i - d i.-1).
Proof.
move=> ND NM ho x0 xm xb.
have N0 : N 0 = 0 by rewrite -(scale0r (0 : V)) NM normr0 mul0r.
have Np u : 0 <= N u.
  by have := ND u (-1 *: u); rewrite NM normrN normr1 mul1r scaleN1r subrr N0 -mulr2n pmulrn_lge0.
have Ns (I : Type) (s : seq I) (P : pred I) F : N (\sum_(i <- s | P i) F i) <= \sum_(i <- s | P i) N (F i).
  by elim/big_rec2: _ => [|i u v _ h]; [rewrite N0|apply: le_trans (ND _ _) _; rewrite ler_add2l].
have hx l : (l <= b)%N -> t 0%N <= x l <= t m.
  by move=> lb; rewrite (le_trans x0) ?(le_trans _ xb) //; apply: (seq_le xm); rewrite ?leq0n ?lb //= leqnn.
apply: (@le_trans _ _ (\sum_(0 <= l < b) \sum_(1 <= i < n.+1) (Tv i (x l.+1) - Tv i (x l)) * N (d i - d i.-1))).
  rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => l /andP[/andP[_ lb] _].
  rewrite !point_abel ?hx // ?(ltnW lb) // opprD addrACA subrr add0r -sumrB.
  apply: le_trans (Ns _ _ _ _) _; rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[/andP[_ im] _].
  rewrite -scalerBl NM ger0_norm // subr_ge0; apply: Tv_mono => //.
  - by case/andP: (hx l (ltnW lb)).
  - exact: xm.
  - by case/andP: (hx l.+1 lb).
rewrite exchange_big /= big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[/andP[_ im] _].
rewrite -mulr_suml telescope_sumr // -[X in _ <= X]mul1r ler_wpmul2r //.
have /andP[_ a] := @Tv_01 i _ ho im (hx b (leqnn b)); have /andP[c _] := @Tv_01 i _ ho im (hx 0%N (leq0n b)).
by rewrite ler_subl_addr (le_trans a) // ler_addl.
Qed.
End Points.

(* X.variation.total: the total variation of a curve is at most that of its control values *)
Theorem variation_curve d (x : nat -> R) b : Uopen t n k -> t 0%N <= x 0%N -> (forall l, (l < b)%N -> x l <= x l.+1) -> x b <= t m ->
  \sum_(0 <= l < b) `|coordinate r t n k d (x l.+1) - coordinate r t n k d (x l)| <= \sum_(1 <= i < n.+1) `|d i - d i.-1|.
Proof.
move=> ho x0 xm xb; have := @length_curve [lmodType R of R^o] (fun u => `|u|) d x b (@ler_norm_add _ _) (@normrM _) ho x0 xm xb.
have E z : @point [lmodType R of R^o] d z = coordinate r t n k d z by apply: eq_bigr => i _; rewrite [RHS]mulrC.
by rewrite (eq_bigr (fun l => `|coordinate r t n k d (x l.+1) - coordinate r t n k d (x l)|)) // => l _; rewrite !E.
Qed.

(* G_j/G_i does not fall where both are positive, i < j; so G_(i+1)/G_i does not *)
Theorem ratio_increasing i j x y : Uinner t n k -> (i < j <= n)%N -> t j < x -> x <= y -> y < t (i + k.+1)%N ->
  value k j x / value k i x <= value k j y / value k i y.
Proof.
move=> hi hij jx xy yi; have /andP[ij jn] := hij.
have im : t (i + k.+1)%N <= t m by apply: tle; rewrite leq_add2r; apply: leq_trans jn; exact: ltnW.
have pos z : t j < z -> z < t (i + k.+1)%N -> 0 < value k i z.
  move=> z1 z2; rewrite value_in ?(lt_le_trans z2) //.
  apply: T3_5_2 => //; [exact: wt_left|exact: wt_range|exact: wt_inside|].
  by rewrite z2 andbT (le_lt_trans _ z1) // tle // ltnW.
move: xy; rewrite le_eqVlt => /orP[/eqP ->|xy]; first exact: lexx.
have x0 : t 0%N <= x by apply: le_trans (ltW jx); exact: tle.
have U : t 0%N < t m by rewrite (le_lt_trans x0) // (lt_le_trans _ im) // (lt_trans xy).
have := minors_2 r_gt0 t_mono hi U hij x0 xy (ltW (lt_le_trans yi im)).
by rewrite subr_ge0 ler_pdivr_mulr ?pos ?(lt_trans xy) // mulrAC ler_pdivl_mulr ?pos ?(lt_trans jx) // [_ * value k i y]mulrC [value k j y * _]mulrC.
Qed.
(* a level c that the control values cross once, from below, the curve crosses at most once *)
Theorem one_level d l c x y : Uopen t n k -> Uinner t n k -> (forall i, (i <= l)%N -> d i <= c) -> (forall i, (l < i <= n)%N -> c <= d i) ->
  t 0%N <= x -> x < y -> y <= t m -> c < coordinate r t n k d x -> c <= coordinate r t n k d y.
Proof.
move=> ho hi lo up x0 xy ym; have U := Uopen_t0 ho.
have E z : t 0%N <= z <= t m -> coordinate r t n k (fun i => d i - c) z = coordinate r t n k d z - c.
  by move=> hz; rewrite (P4_1_4_printed r_gt0 t_mono U d (- c) ho hz).
rewrite -subr_gt0 -E ?x0 ?(le_trans (ltW xy)) // => h.
have := @one_crossing R r r_gt0 t t_mono n k hi (fun i => d i - c) l x y U _ _ x0 xy ym h.
rewrite E ?ym ?(le_trans x0 (ltW xy)) // subr_ge0; apply => i hil; [rewrite subr_le0|rewrite subr_ge0]; [exact: lo|exact: up].
Qed.

(* ---- the hodograph ---- *)
(* T_i' at x, on the span s *)
Definition A s i x : R := dT (fun e j => mw r t e j x) (fun e j => dmw r t e j x) s k i.
Section Span.
Variable s : nat.
Hypothesis ss : t s < t s.+1.
Lemma dmw_gt0 e j x : t s <= x <= t s.+1 -> (j <= s < j + e)%N -> 0 < dmw r t e j x.
Proof.
move=> /andP[x1 x2] hj; have ab := span_ab t_mono ss hj; have /andP[h1 h2] := hj.
have D : 0 < r * (x - t j) + (t (j + e)%N - x).
  by apply: mob_den_gt0 => //; [exact: le_trans (tle h1) x1|exact: le_trans x2 (tle h2)].
by rewrite /dmw /dmob divr_gt0 ?exprn_gt0 // mulr_gt0 // subr_gt0.
Qed.
Lemma A_ge0 i x : t s <= x <= t s.+1 -> 0 <= A s i x.
Proof. by move=> hx; apply: dT_ge0 => e j hj; [exact: (span_01 t_mono ss r_gt0 hx)|apply/ltW/dmw_gt0]. Qed.
Lemma A_gt0 i x : t s < x < t s.+1 -> (s - k < i <= s)%N -> 0 < A s i x.
Proof.
move=> hx hi; have /andP[x1 x2] := hx; apply: dT_gt0 => [e j hj|e j hj|]; last by move: hi; clear; lia.
  exact: (span_in t_mono r_gt0 hx).
by apply: dmw_gt0 => //; rewrite !ltW.
Qed.
Hypothesis sn : (k <= s <= n)%N.
(* the derivatives of the functions, summed up with the points: a combination of the k legs of the span, with the factors A_i *)
Theorem hodograph_points (V : lmodType R) (d : nat -> V) x :
  \sum_(0 <= i < n.+1) dP r t s k i x *: d i = \sum_((s - k).+1 <= i < s.+1) A s i x *: (d i - d i.-1).
Proof.
have /andP[ks sn'] := sn; have S i : (i <= n.+1)%N -> \sum_(i <= j < n.+1) dP r t s k j x = A s i x.
  by move=> ib; rewrite /dP dT_sum // ltnS.
rewrite abel_points S // {1}/A dT_low // scale0r add0r.
rewrite (eq_big_nat _ _ (F2 := fun i => A s i x *: (d i - d i.-1))); last by move=> i /andP[_ h]; rewrite S // ltnW.
rewrite (big_cat_nat _ (n := (s - k).+1)) //=; last by move: ks sn'; clear; lia.
rewrite big_nat_cond big1 ?add0r; last first.
  by move=> i /andP[/andP[_ h] _]; rewrite /A dT_low ?scale0r //; move: h ks; clear; lia.
rewrite (big_cat_nat _ (n := s.+1)) //=; last by move: ks; clear; lia.
rewrite [X in _ + X]big_nat_cond [X in _ + X]big1 ?addr0 //.
by move=> i /andP[/andP[h _] _]; rewrite /A dT_high ?scale0r.
Qed.
End Span.
(* X.hodograph: the derivatives of the curve from both sides are combinations of the legs of the span there, with factors >= 0, and > 0
   inside of the span *)
Theorem hodograph s d x : t 0%N < t m -> (k <= s <= n)%N -> t s < t s.+1 ->
  [/\ t s <= x < t s.+1 -> right_taylor (curve_in r t n k d) x (coordinate r t n k d x) (\sum_((s - k).+1 <= i < s.+1) A s i x * (d i - d i.-1)),
      t s < x <= t s.+1 -> left_taylor (curve_in r t n k d) x (\sum_(0 <= i < n.+1) d i * limit_left r t m k i x)
        (\sum_((s - k).+1 <= i < s.+1) A s i x * (d i - d i.-1)),
      t s <= x <= t s.+1 -> forall i, 0 <= A s i x & t s < x < t s.+1 -> forall i, (s - k < i <= s)%N -> 0 < A s i x].
Proof.
move=> U hs ss; have /andP[ks sn] := hs; have sm : (s < m)%N by move: sn; clear; lia.
have H := hodograph_points hs (V := [lmodType R of R^o]) d x.
split=> [hx|hx|hx i|hx i hi]; [| |exact: A_ge0|exact: A_gt0].
- have /andP[x1 x2] := hx; have hx' : t 0%N <= x < t m by rewrite (le_trans (tle (leq0n s)) x1) (lt_le_trans x2) ?tle.
  have := C_right r_gt0 t_mono d hx'; congr right_taylor; rewrite -[RHS]H; apply: eq_bigr => i _.
  by rewrite /Values.Dright (right_span_uniq t_mono sm hx) mulrC.
have /andP[x1 x2] := hx; have hx' : t 0%N < x <= t m by rewrite (le_lt_trans (tle (leq0n s)) x1) (le_trans x2) ?tle.
have := C_left r_gt0 t_mono d hx'; congr left_taylor; rewrite -[RHS]H; apply: eq_bigr => i _.
by rewrite /Values.Dleft (left_span_uniq t_mono sm hx) mulrC.
Qed.
(* X.monotone: inside of a span T_j = G_j + .. + G_n rises strictly, l-k < j <= l *)
Theorem X_monotone_printed l j x : (k <= l <= n)%N -> (l - k < j <= l)%N -> t l < x < t l.+1 ->
  0 < \sum_(j <= i < n.+1) DGright r t m k i x.
Proof.
move=> /andP[_ ln] hj hx; have /andP[x1 x2] := hx; have /andP[_ jl] := hj.
have lm : (l < m)%N by rewrite addnS ltnS (leq_trans ln) ?leq_addr.
have hx' : t l <= x < t l.+1 by rewrite ltW.
rewrite (eq_bigr (fun i => dP r t l k i x)) => [|i _]; last exact: DGright_span.
rewrite /dP dT_sum ?ltnS // ?(leqW (leq_trans jl ln)) //; apply: A_gt0 => //; exact: lt_trans x2.
Qed.
End Shape.

Section Ratio.
Variable R : realFieldType.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Lemma mob_r_le (r r' x a b : R) : 0 < r -> r <= r' -> a <= x -> x < b -> mob r x a b <= mob r' x a b.
Proof.
move=> r0; rewrite le_eqVlt => /orP[/eqP ->//|rr]; rewrite le_eqVlt => /orP[/eqP <- xb|ax xb]; first by rewrite !mob_a.
exact/ltW/mob_r.
Qed.
(* X.order.curve: control values that do not fall make a curve that rises with r, at every point *)
Theorem curve_rises_with_r (r r' : R) d x : 0 < r -> r <= r' -> Uopen t n k -> (forall i, (i < n)%N -> d i <= d i.+1) ->
  t 0%N <= x <= t m -> coordinate r t n k d x <= coordinate r' t n k d x.
Proof.
move=> r0 rr ho hd /andP[x0 xm]; have r0' := lt_le_trans r0 rr; have U := Uopen_t0 ho; have [e0 e1 e2] := ho.
move: xm; rewrite le_eqVlt => /orP[/eqP ->|xm]; first by rewrite (C_tm r0 t_mono U) ?(C_tm r0' t_mono U).
have [s [/andP[ks sn] hx]] : exists s, (k <= s < n.+1)%N /\ t s <= x < t s.+1.
  by apply: span_exists => //; rewrite -e0 x0 e1.
have hs : (k <= s <= n)%N by rewrite ks -ltnS.
have /andP[x1 x2] := hx; have ss := le_lt_trans x1 x2; have hx' : t s <= x <= t s.+1 by rewrite x1 ltW.
rewrite !(C_abel t_mono _ _ hs hx) ler_add2l big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[/andP[i1 i2] _].
apply: ler_wpmul2l; first by rewrite subr_ge0; case: i i1 i2 => // i _ i2; apply: hd.
apply: T_le => e j; [exact: (span_01 t_mono ss r0 hx')|exact: (span_01 t_mono ss r0' hx')|].
move=> /andP[h1 h2] _; apply: mob_r_le => //; [exact: le_trans (tle h1) x1|exact: lt_le_trans x2 (tle h2)].
Qed.
End Ratio.
