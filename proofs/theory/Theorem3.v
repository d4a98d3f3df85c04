(* Theorem 3 for the paper's own recursion D3.3: inside a span every G_i^k rises, falls, or rises and then falls, strictly. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Definitions Weight Race RationalDerivative Theorem3Table.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.

Local Notation t_le := (Definitions.t_le t_mono).
Local Notation wgt := (wt r t).
Local Notation N := (Definitions.G (wt r t) t).

Variable s : nat.
Definition tL n := t (s - n).
Definition tR m := t (s.+1 + m).
Lemma tLu n : tL n <= t s. Proof. by apply: t_le; apply: leq_subr. Qed.
Lemma tRv m : t s.+1 <= tR m. Proof. by apply: t_le; apply: leq_addr. Qed.
Lemma tL_mono n : tL n.+1 <= tL n. Proof. by apply: t_le; rewrite leq_sub2l. Qed.
Lemma tR_mono m : tR m <= tR m.+1. Proof. by apply: t_le; rewrite leq_add2l. Qed.
Notation G x n m := (G3 r tL tR x n m).1.1.
Notation G' x n m := (G3 r tL tR x n m).1.2.

Lemma N_out k i x : t s < x < t s.+1 -> (s < i)%N || (i + k < s)%N -> N k i x = 0.
Proof.
case/andP=> sx xs h; have hs : t s <= x < t s.+1 by rewrite (ltW sx).
by rewrite (G_N t_mono _ _ _ hs) N_supp // negb_and -!ltnNge.
Qed.

Lemma wgt_in x n m i k : t s < x < t s.+1 -> (i + n = s)%N -> (k = n + m.+1)%N ->
  wgt k i x = (tw r tL tR x n m).1.1.
Proof.
case/andP=> sx xs e ->; rewrite /wt /phi /mob /tw /den /= /a /b.
have -> : tL n = t i by rewrite /tL -e addnK.
have -> : tR m = t (i + (n + m.+1)) by rewrite /tR -e addSnnS addnA.
have -> : t i <= x by apply: (le_trans _ (ltW sx)); apply: t_le; rewrite -e leq_addr.
have -> : x < t (i + (n + m.+1)) by apply: (lt_le_trans xs); apply: t_le; rewrite addnA e addnS ltnS leq_addr.
by [].
Qed.

(* the recursion D3.3 is the table of the race: n = s-i left knots, m = k-n right knots *)
Theorem G_table n m i x : t s < x < t s.+1 -> (i + n = s)%N -> N (n + m) i x = G x n m.
Proof.
move=> hx; have [d] := ubnP (n + m)%N; elim: d n m i => // d IH n m i; rewrite ltnS => le e.
have vw n' m' : (tv r tL tR x n' m').1.1 = 1 - (tw r tL tR x n' m').1.1.
  have := den0 r0 tLu tRv n' m' hx; rewrite /tv /tw /den /=.
  by move: (a _ x n') (b _ x m') => p q0 dn; field.
case: n m le e => [|n] [|m] le e.
- rewrite addn0 in e; rewrite /= e; by case/andP: hx => h1 h2; rewrite (ltW h1) h2.
- have o : N m i.+1 x = 0 by apply: (N_out hx); rewrite -e addn0 ltnSn.
  have h := IH 0%N m i le e; rewrite add0n in h.
  have hw : wgt m.+1 i x = (tw r tL tR x 0 m).1.1 by apply: wgt_in.
  by rewrite add0n GS o mulr0 addr0 hw h.
- have o : N n i x = 0 by apply: (N_out hx); rewrite -e addnS ltnSn orbT.
  have e' : (i.+1 + n = s)%N by rewrite addSnnS.
  have le' : (n + 0 < d)%N by [].
  have h := IH n 0%N i.+1 le' e'; rewrite addn0 in h.
  have hw : wgt n.+1 i.+1 x = (tw r tL tR x n 0).1.1 by apply: wgt_in => //; rewrite addn1.
  by rewrite addn0 GS o mulr0 add0r hw h -vw.
- have e' : (i.+1 + n = s)%N by rewrite addSnnS.
  have le1 : (n.+1 + m < d)%N by rewrite addnS in le.
  have le2 : (n + m.+1 < d)%N by rewrite -addSnnS.
  have h1 := IH n.+1 m i le1 e; have h2 := IH n m.+1 i.+1 le2 e'; rewrite -addSnnS in h2.
  have hw1 : wgt (n.+1 + m).+1 i x = (tw r tL tR x n.+1 m).1.1 by apply: wgt_in => //; rewrite addnS.
  have hw2 : wgt (n.+1 + m).+1 i.+1 x = (tw r tL tR x n m.+1).1.1.
    by apply: wgt_in => //; rewrite !addnS addSn.
  by rewrite addnS GS h1 h2 hw1 hw2 -vw G3SS.
Qed.
End Paper.

Section Rational.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Notation N := (Definitions.G (wt r t) t).

(* On every open knot span G_i^k is a rational function; its derivative N' (isd: quotient rule, unique by isd_uniq) *)
Theorem G_rational k i s : exists N', isd (t s) (t s.+1) (N k i) N'.
Proof.
case: (boolP ((s < i)%N || (i + k < s)%N)) => h.
  by exists (fun _ => 0); apply: (isd_ext (isd_const _ _ 0)) => x hx //; exact: (@N_out _ r t t_mono s k i x hx h).
move: h; rewrite negb_or -!leqNgt => /andP[is_ sk].
have [d _] := G3_der r0 (tLu t_mono s) (tRv t_mono s) (s - i) (k - (s - i)).
exists (fun x => (G3 r (tL t s) (tR t s) x (s - i) (k - (s - i))).1.2).
apply: (isd_ext d) => x hx //.
rewrite -(G_table r0 t_mono _ hx (subnKC is_)) subnKC //.
by rewrite leq_subLR.
Qed.

End Rational.

Section Theorem3.
Variable R : rcfType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Notation N := (Definitions.G (wt r t) t).

(* Theorem 3 of the paper, for every k >= 1, all knots, all r > 0, every span of the support of G_i^k (s - k <= i <= s) *)
Theorem paper_theorem3 k i s N' x y : (0 < k)%N -> (i <= s <= i + k)%N -> isd (t s) (t s.+1) (N k i) N' ->
  t s < x -> x < y -> y < t s.+1 -> N' x <= 0 -> N' y < 0.
Proof.
move=> k0 /andP[is_ sk] h sx xy ys.
pose n := (s - i)%N; pose m := (k - n)%N.
have nm : (n + m = k)%N by rewrite subnKC // leq_subLR.
have [d _] := G3_der r0 (tLu t_mono s) (tRv t_mono s) n m.
have e z : t s < z < t s.+1 -> N k i z = (G3 r (tL t s) (tR t s) z n m).1.1.
  by move=> hz; rewrite -nm; apply: (G_table r0 t_mono); rewrite ?subnKC.
have hx : t s < x < t s.+1 by rewrite sx (lt_trans xy). have hy : t s < y < t s.+1 by rewrite (lt_trans sx).
rewrite (isd_uniq h d e hx) (isd_uniq h d e hy).
by apply: (theorem3 r0 (tLu t_mono s) (tRv t_mono s) (tL_mono t_mono s) (tR_mono t_mono s)); rewrite ?nm.
Qed.

(* X.maxima.spans: Theorem 3: inside of a span of the support G is above the smaller of two values around, real closed fields *)
Theorem paper_unimodal k i s x y z : (0 < k)%N -> (i <= s <= i + k)%N ->
  t s < x -> x < y -> y < z -> z < t s.+1 -> Num.min (N k i x) (N k i z) < N k i y.
Proof.
move=> k0 /andP[is_ sk] sx xy yz zs.
pose n := (s - i)%N; pose m := (k - n)%N.
have nm : (n + m = k)%N by rewrite subnKC // leq_subLR.
have e w : t s < w < t s.+1 -> N k i w = (G3 r (tL t s) (tR t s) w n m).1.1.
  by move=> hw; rewrite -nm; apply: (G_table r0 t_mono); rewrite ?subnKC.
have xz := lt_trans xy yz.
rewrite !e ?sx ?zs ?(lt_trans sx xy) ?(lt_trans yz zs) ?(lt_trans sx xz) ?(lt_trans xz zs) //.
by apply: (unimodal r0 (tLu t_mono s) (tRv t_mono s) (tL_mono t_mono s) (tR_mono t_mono s)); rewrite ?nm.
Qed.
End Theorem3.
