(* Curves: T4.1 (de Boor, all levels), P4.1, and the core of abstract.approx, for every degree and any weights. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Curves.
Variable R : realFieldType.
Variable w : nat -> nat -> R -> R.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable V : lmodType R.
Local Notation G := (G w t).
Local Notation curve := (@curve R V w t).
(* the paper's points d_i^q(x) *)
Definition deBoor k (d : nat -> V) q i x : V := dB (fun e j => w e j x) k d q i.

Lemma deBoor0 k d i x : deBoor k d 0 i x = d i. Proof. by []. Qed.
Lemma deBoorS k d q i x :
  deBoor k d q.+1 i x = w (k - q)%N i x *: deBoor k d q i x + (1 - w (k - q)%N i x) *: deBoor k d q i.-1 x.
Proof. by []. Qed.

(* P4.1.2: the same for any numbers as weights, points in any vector space *)
Theorem P4_1_2 k n j (d : nat -> V) x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  curve k n d x = \sum_(j - k <= i < j.+1) G k i x *: d i.
Proof. exact: sum_local. Qed.

(* T4.1: the same for any numbers as weights, points in any vector space *)
Theorem T4_1 k n j (d : nat -> V) x q : (k <= j <= n)%N -> t j <= x < t j.+1 -> (q <= k)%N ->
  curve k n d x = \sum_(j - k + q <= i < j.+1) G (k - q) i x *: deBoor k d q i x.
Proof.
move=> hj h hq; rewrite (P4_1_2 _ hj h).
transitivity (\sum_(j - k <= i < j.+1) N (fun e i => w e i x) j k i *: d i).
  by apply: eq_bigr => i _; rewrite (G_N t_mono w _ _ h).
rewrite (@N_deBoor _ _ _ _ _ _ q) //; last by case/andP: hj.
by apply: eq_bigr => i _; rewrite (G_N t_mono w _ _ h).
Qed.

(* all levels: the curve is the last point *)
Theorem T4_1_last k n j (d : nat -> V) x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  curve k n d x = deBoor k d k j x.
Proof.
move=> hj h; rewrite (T4_1 d hj h (leqnn k)) subnn subnK; last by case/andP: hj.
by rewrite big_nat1 G0 h scale1r.
Qed.

(* P4.1.1: outside [t_j, t_(j+k+1)) the point d_j does not act *)
Theorem P4_1_1 k n j (d d' : nat -> V) x : (forall i, i != j -> d i = d' i) ->
  ~~ (t j <= x < t (j + k.+1)%N) -> curve k n d x = curve k n d' x.
Proof.
move=> h hx; apply: eq_bigr => i _; case: (eqVneq i j) => [->|e]; last by rewrite h.
by rewrite T3_5_1_outside // !scale0r.
Qed.

(* and inside it does: *)
Theorem P4_1_1_conv k n j (d d' : nat -> V) x : w_left w t -> w_range w -> w_inside w t ->
  (forall i, i != j -> d i = d' i) -> d j != d' j -> (j <= n)%N ->
  t j < x < t (j + k.+1)%N -> curve k n d x != curve k n d' x.
Proof.
move=> w0 w1 wi h hd jn hx; rewrite -subr_eq0 /Definitions.curve -sumrB.
rewrite (bigD1_seq j) ?mem_index_iota ?iota_uniq //= big1 ?addr0; last first.
  by move=> i e; rewrite h // subrr.
by rewrite -scalerBr scaler_eq0 negb_or subr_eq0 hd andbT gt_eqF // T3_5_2.
Qed.

(* P4.1.4: an affine map T u = L u + c *)
Theorem P4_1_4 (V' : lmodType R) (L : {linear V -> V'}) (c : V') k n (d : nat -> V) x : t k <= x < t n.+1 ->
  L (curve k n d x) + c = Definitions.curve w t k n (fun i => L (d i) + c) x.
Proof.
move=> h; rewrite /Definitions.curve linear_sum.
rewrite [in RHS](eq_bigr (fun i => L (G k i x *: d i) + G k i x *: c)); last first.
  by move=> i _; rewrite scalerDr linearZ.
by rewrite big_split /= -scaler_suml T3_5_3_interval // scale1r.
Qed.
End Curves.


(* abstract.approx, the core: the error at x is at most the largest |f x - f(xi_i)| over the k+1 functions that act at x *)
Theorem abstract_approx (R : realFieldType) (w : nat -> nat -> R -> R) (t : nat -> R) k n j (f : R -> R) (xi : nat -> R) M x :
  (forall i, t i <= t i.+1) -> w_range w -> (k <= j <= n)%N -> t j <= x < t j.+1 ->
  (forall i, (j - k <= i <= j)%N -> `|f x - f (xi i)| <= M) ->
  `|f x - \sum_(0 <= i < n.+1) G w t k i x * f (xi i)| <= M.
Proof.
move=> mono w1 hj hx H.
have h1 := @sum_local R w t mono [lmodType R of R^o] k n j x (fun i => f (xi i)) hj hx.
rewrite /GRing.scale /= in h1; rewrite h1.
have s1 : \sum_(j - k <= i < j.+1) G w t k i x = 1 by apply: T3_5_3_local => //; case/andP: hj.
have -> : f x - \sum_(j - k <= i < j.+1) G w t k i x * f (xi i) = \sum_(j - k <= i < j.+1) G w t k i x * (f x - f (xi i)).
  rewrite -{1}[f x]mul1r -s1 mulr_suml -sumrB; apply: eq_bigr => i _; ring.
rewrite -[M]mul1r -s1 mulr_suml; apply: le_trans (ler_norm_sum _ _ _) _.
rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[hi _].
have g0 : 0 <= G w t k i x by apply: T3_5_2_nonneg.
by rewrite normrM ger0_norm // ler_wpmul2l // H.
Qed.
