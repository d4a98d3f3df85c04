(* X.condition as amended: without interior knots the basis is that of Bernstein in f, and a curve with large control points that stays
   between -1 and 1, whose coordinate is Chebyshev's polynomial of 2f - 1. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify complex.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis StatementsCurves StatementsBernstein Cumulative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* even and odd indices *)
Lemma even_odd (V : zmodType) (f : nat -> V) k : \sum_(0 <= j < k.*2.+1) f j = \sum_(0 <= i < k.+1) f i.*2 + \sum_(0 <= i < k) f i.*2.+1.
Proof.
elim: k => [|k IH]; first by rewrite !big_nat1 big_geq // addr0.
rewrite doubleS big_nat_recr //= big_nat_recr //= IH [in RHS]big_nat_recr //= [X in _ = _ + X]big_nat_recr //= doubleS.
by rewrite -!addrA; congr (_ + _); rewrite addrA [LHS]addrC.
Qed.
Lemma even_part (S : comRingType) (c y : S) k : (y + c) ^+ k.*2 + (- y + c) ^+ k.*2 =
  (\sum_(0 <= i < k.+1) (y ^+ 2) ^+ (k - i) * (c ^+ 2) ^+ i * 'C(k.*2, i.*2)%:R) *+ 2.
Proof.
have E (z : S) : (z + c) ^+ k.*2 = \sum_(0 <= i < k.+1) (z ^+ 2) ^+ (k - i) * (c ^+ 2) ^+ i * 'C(k.*2, i.*2)%:R +
    z * \sum_(0 <= i < k) (z ^+ 2) ^+ (k - i.+1) * c ^+ i.*2.+1 * 'C(k.*2, i.*2.+1)%:R.
  rewrite exprDn -(big_mkord predT (fun j => z ^+ (k.*2 - j) * c ^+ j *+ 'C(k.*2, j))) even_odd mulr_sumr; congr (_ + _).
    by apply: eq_big_nat => i _; rewrite -doubleB -!mul2n !exprM mulr_natr.
  apply: eq_big_nat => i /andP[_ ik]; rewrite -exprM mul2n.
  have -> : (k.*2 - i.*2.+1 = (k - i.+1).*2.+1)%N by rewrite doubleB doubleS; move: ik; clear; lia.
  by rewrite exprS mulr_natr !mulrnAr !mulrA.
by rewrite !E sqrrN mulNr addrACA subrr addr0 mulr2n.
Qed.
(* Chebyshev's polynomial, in Bernstein's form *)
Theorem chebyshev (R : rcfType) (w : R) k : 0 <= w <= 1 ->
  `|\sum_(0 <= i < k.+1) (-1) ^+ (k - i) * 'C(k.*2, i.*2)%:R * (w ^+ i * (1 - w) ^+ (k - i))| <= 1.
Proof.
move=> /andP[w0 w1]; have v0 : 0 <= 1 - w by rewrite subr_ge0.
set A := \sum_(0 <= i < k.+1) _.
pose c : R[i] := (Num.sqrt w)%:C%C; pose y : R[i] := ('i * (Num.sqrt (1 - w))%:C)%C.
have c2 : c ^+ 2 = w%:C%C by rewrite /c -rmorphX /= sqr_sqrtr.
have y2 : y ^+ 2 = (- (1 - w))%:C%C by rewrite /y exprMn sqr_i -rmorphX /= sqr_sqrtr // mulN1r -rmorphN.
have EA : (y + c) ^+ k.*2 + (- y + c) ^+ k.*2 = (A%:C *+ 2)%C.
  rewrite even_part y2 c2 /A rmorph_sum; congr (_ *+ 2); apply: eq_bigr => i _.
  rewrite !rmorphM !rmorphX /= rmorphN1 rmorph_nat [X in X ^+ (k - i)](_ : _ = -1 * (1 - w)%:C%C); last by rewrite rmorphN mulN1r.
  by rewrite exprMn -!mulrA; congr (_ * _); rewrite mulrA mulrC [_ * (w%:C)%C ^+ i]mulrC.
have N (z : R[i]) : complex.Re z ^+ 2 + complex.Im z ^+ 2 = 1 -> `|z| = 1 by move=> h; rewrite normc_def h sqrtr1.
have sw : Num.sqrt w ^+ 2 + Num.sqrt (1 - w) ^+ 2 = 1 by rewrite !sqr_sqrtr // addrC subrK.
have n1 : `|y + c| = 1 by apply: N; rewrite /y /c /= !(mul0r, mulr0, mul1r, add0r, addr0, subr0, sub0r, oppr0).
have n2 : `|- y + c| = 1 by apply: N; rewrite /y /c /= !(mul0r, mulr0, mul1r, add0r, addr0, subr0, sub0r, oppr0) ?sqrrN.
have : `|(A%:C *+ 2)%C| <= 2%:R :> R[i].
  by rewrite -EA; apply: le_trans (ler_norm_add _ _) _; rewrite !normrX n1 n2 !expr1n.
rewrite normrMn normc_def /= expr0n addr0 sqrtr_sqr -[_ *+ 2]mulr_natl -[X in _ <= X]mulr1 ler_pmul2l ?ltr0n //.
by rewrite -[1]/((1 : R)%:C)%C lecR.
Qed.

Section Statement.
Variable R : rcfType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable k : nat.
Local Notation m := (k + k.+1)%N.
(* X.condition as amended *)
Theorem X_condition_amended x : (1 <= k)%N -> Uopen t k k -> t 0%N <= x <= t m ->
  (forall i, (i <= k)%N -> value r t m k i x = 'C(k, i)%:R * mob r x (t 0%N) (t m) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i)) /\
  `|\sum_(0 <= i < k.+1) (-1) ^+ (k - i) * 'C(k.*2, i.*2)%:R / 'C(k, i)%:R * value r t m k i x| <= 1.
Proof.
move=> _ ho hx; have V i : (i <= k)%N -> value r t m k i x = 'C(k, i)%:R * mob r x (t 0%N) (t m) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i).
  by move=> ik; apply: bern_closed.
split=> //; have /andP[x0 xm] := hx; have U := Uopen_t0 ho.
have H := chebyshev k (mob_01 r_gt0 x0 xm U); rewrite (eq_big_nat _ _ (F2 := fun i => (-1) ^+ (k - i) * 'C(k.*2, i.*2)%:R *
  (mob r x (t 0%N) (t m) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i)))) // => i /andP[_ ik]; rewrite ltnS in ik.
have n : ('C(k, i)%:R : R) != 0 by rewrite pnatr_eq0 -lt0n bin_gt0.
by rewrite V //; move: (mob r x _ _ ^+ i) ((1 - mob r x _ _) ^+ _) ((-1) ^+ _ * _) n => p q u n; field.
Qed.
End Statement.
