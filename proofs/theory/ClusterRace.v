(* The race of theory.md with some clocks that are slow against the others. G_0^k is a difference of two chances, each of which may be
   computed with the knots taken away in any order; where all knots but the outer ones lie close together, each is a product up to the
   third order in their distances. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Tower.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Lists.
Variable R : realFieldType.
Implicit Types (a b p q : R) (A B : seq R).
(* lengths that can race: not negative, no two of the two sides both 0 *)
Definition sides A B := all (fun a => 0 <= a) A && all (fun b => 0 <= b) B && all (fun a => all (fun b => 0 < a + b) B) A.
Lemma sides_tail A b B : sides A (b :: B) -> sides A B.
Proof. by rewrite /sides /= => /andP[/andP[-> /andP[_ ->]] h]; apply/allP => x xA; have /andP[] := allP h x xA. Qed.
Lemma sides_cons a A b B : sides (a :: A) (b :: B) -> [/\ 0 < a + b, sides A (b :: B) & sides (a :: A) B].
Proof.
rewrite /sides /= => /andP[/andP[/andP[a0 hA] /andP[b0 hB]] /andP[/andP[ab h1] h2]].
have h3 : all (fun a => all (fun b => 0 < a + b) B) A by apply/allP => x xA; have /andP[] := allP h2 x xA.
by split=> //; apply/andP; split=> //; rewrite ?hA ?a0 ?b0 ?hB //= h1.
Qed.
(* the other side wins with the rest of the chance *)
Lemma cl_swap A B : sides A B -> (0 < size A + size B)%N -> cl B A = 1 - cl A B.
Proof.
elim: A B => [|a A IHA] B; first by case: B => [|b B] // _ _; rewrite clA0 cl0 subr0.
elim: B => [|b B IHB] h _; first by rewrite clA0 cl0 subrr.
have [ab h1 h2] := sides_cons h; rewrite !clE IHB ?IHA //=; last by rewrite addnS.
move: (cl (a :: A) B) (cl A (b :: B)) => X Y; have n1 : a + b != 0 by rewrite gt_eqF. have n2 : b + a != 0 by rewrite addrC.
by field; rewrite ?n1 ?n2.
Qed.
(* the relation of the right side, where q may be 0 *)
Lemma rightrel0 A p q B : all (fun a => (a + p != 0) && (a + q != 0)) A -> p != 0 ->
  (q - p) * cl A (p :: q :: B) = q * cl A (q :: B) - p * cl A (p :: B).
Proof.
move=> hA pn; elim: A hA => [|a A IH]; first by rewrite !cl0 !mulr0 subrr.
case/andP=> /andP[pa qa] hA; have {IH} := IH hA; rewrite !clE.
move: (cl (a :: A) B) (cl A (p :: q :: B)) (cl A (q :: B)) (cl A (p :: B)) => X Z Q P e.
have -> : P = (q * Q - (q - p) * Z) / p by rewrite e opprB addrC subrK mulrC mulKf.
by field; rewrite pa qa pn.
Qed.
Lemma swap0 A p q B : all (fun a => (a + p != 0) && (a + q != 0)) A -> p != 0 -> cl A (p :: q :: B) = cl A (q :: p :: B).
Proof.
move=> hA pn; case: (eqVneq q 0) => [q0|qn].
  have pn' : - p != 0 by rewrite oppr_eq0.
  apply: (mulfI pn'); have := rightrel0 B hA pn; rewrite q0 mul0r !sub0r => ->.
  case: A hA => [|a A]; first by rewrite !cl0 !(mulr0, oppr0).
  case/andP=> /andP[_]; rewrite q0 addr0 => an _; rewrite [cl _ (0 :: _)]clE mul0r !addr0.
  by move: (cl _ _) => X; field.
case: (eqVneq p q) => [-> //|n]; have d : q - p != 0 by rewrite subr_eq0 eq_sym.
apply: (mulfI d); rewrite rightrel0 //.
have -> : (q - p) * cl A (q :: p :: B) = - ((p - q) * cl A (q :: p :: B)) by ring.
rewrite rightrel0 //; first by ring.
by apply/allP => a ha; rewrite andbC; apply: (allP hA).
Qed.
Lemma cons_right A b B B' : (forall A', subseq A' A -> cl A' B = cl A' B') -> cl A (b :: B) = cl A (b :: B').
Proof.
elim: A => [|a A IH] h; first by rewrite !cl0.
rewrite !clE h // IH // => A' s; apply: h; apply: subseq_trans s _; exact: subseq_cons.
Qed.
(* the first of a list may as well be the last *)
Lemma first_last A p B : 0 < p -> sides A B -> cl A (p :: B) = cl A (rcons B p).
Proof.
move=> p0; elim: B A => [|q B IH] A h //; have pn : p != 0 by rewrite gt_eqF.
have /andP[/andP[hA /andP[q0 hB]] hAB] := h.
rewrite swap0 //; last first.
  apply/allP => a ha; rewrite gt_eqF ?addr_ge0 ?ltr_paddl //; last exact: (allP hA).
  by have /andP[/gt_eqF -> _] := allP hAB a ha.
rewrite rcons_cons; apply: cons_right => A' s; apply: IH; have hB' : all (fun b => 0 <= b) B := hB.
rewrite /sides hB' andbT; have sub x : x \in A' -> x \in A by apply: mem_subseq.
apply/andP; split; first by apply/allP => x /sub; apply: (allP hA).
by apply/allP => x /sub xA; have /andP[] := allP hAB x xA.
Qed.

(* the product, and what the chance differs from it by; b is the last of the right ones *)
Definition prod A B b := (\prod_(a <- A) (b / (b + a))) * (\prod_(m <- B) (b / (b - m))).
Definition rest A B b := 1 - cl A (rcons B b) - prod A B b.
(* the product obeys the recursion, and so does what is left out *)
Lemma rest_step a A m B b : a + m != 0 -> b + a != 0 -> b - m != 0 ->
  rest (a :: A) (m :: B) b = a / (a + m) * rest (a :: A) B b + m / (a + m) * rest A (m :: B) b.
Proof.
move=> n1 n2 n3; rewrite /rest /prod !rcons_cons clE !big_cons.
move: (cl (a :: A) _) (cl A _) (\prod_(_ <- A) _) (\prod_(_ <- B) _) => u v X Y.
by field; rewrite ?n1 ?n2 ?n3.
Qed.
(* nothing is left out if b is the only one on the right; the other end is rest_left *)
Lemma rest_right A b : all (fun a => b + a != 0) A -> rest A [::] b = 0.
Proof.
rewrite /rest /prod big_nil mulr1 /=; elim: A => [|a A IH]; first by rewrite cl0 big_nil subr0 subrr.
case/andP=> n h; rewrite clE clA0 big_cons; have := IH h; move: (cl A _) (\prod_(_ <- A) _) => u X e.
have -> : u = 1 - X by move: e => /eqP; rewrite subr_eq0 => /eqP <-; ring.
have n' : a + b != 0 by rewrite addrC.
by field; rewrite ?n ?n'.
Qed.
Lemma rest_left B b : rest [::] B b = 1 - \prod_(m <- B) (b / (b - m)).
Proof. by rewrite /rest /prod cl0 big_nil mul1r subr0. Qed.
End Lists.

(* ---- G_0^k as a difference of two chances ---- *)
Section Chances.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables (s : nat) (x : R).
Hypothesis hx : t s <= x < t s.+1.
(* the left knots from t_i on, the right ones up to t_e, the farthest first *)
Definition left_of i := [seq x - t l | l <- iota i (s.+1 - i)].
Definition right_of e := [seq (t l - x) / r | l <- rev (iota s.+1 (e - s))].
Fixpoint chance k i : R := if k is d.+1 then mw r t d.+1 i x * chance d i + (1 - mw r t d.+1 i x) * chance d i.+1 else (i <= s)%N%:R.
Lemma piece_chance k i : P r t s k i x = chance k i - chance k i.+1.
Proof.
rewrite /P /piece; elim: k i => [|k IH] i; last by rewrite NS !IH /=; ring.
rewrite /=; case: (ltngtP i s) => h; rewrite ?subrr ?subr0 //.
Qed.
Lemma left_ge l : (l <= s)%N -> 0 <= x - t l.
Proof. by move=> h; rewrite subr_ge0 (le_trans (t_le t_mono h)) //; case/andP: hx. Qed.
Lemma right_gt l : (s < l)%N -> 0 < (t l - x) / r.
Proof. by move=> h; rewrite divr_gt0 // subr_gt0 (lt_le_trans _ (t_le t_mono h)) //; case/andP: hx. Qed.
(* the recursion of the paper is that of the race, knots at x included *)
Lemma chance_cl k i : chance k i = cl (left_of i) (right_of (i + k)).
Proof.
elim: k i => [|k IH] i.
  rewrite addn0 /left_of /right_of /=; case: (leqP i s) => h.
    have -> : (i - s = 0)%N by move: h; clear; lia.
    by rewrite subSn //= clA0.
  have -> : (s.+1 - i = 0)%N by move: h; clear; lia.
  by rewrite cl0.
rewrite [LHS]/= !IH; case: (leqP i s) => h; last first.
  have e1 : (s.+1 - i = 0)%N by move: h; clear; lia. have e2 : (s.+1 - i.+1 = 0)%N by move: h; clear; lia.
  by rewrite /left_of e1 e2 !cl0 !mulr0 addr0.
have L : left_of i = (x - t i) :: left_of i.+1 by rewrite /left_of subSS subSn.
case: (ltnP s (i + k.+1)) => h2; last first.
  have e1 : (i + k - s = 0)%N by move: h2; clear; lia. have e2 : (i + k.+1 - s = 0)%N by move: h2; clear; lia.
  have e3 : (i.+1 + k - s = 0)%N by move: h2; clear; lia.
  rewrite /right_of e1 e2 e3 /= L clA0; have -> : left_of i.+1 = (x - t i.+1) :: left_of i.+2.
    have e4 : (s.+1 - i.+1 = (s.+1 - i.+2).+1)%N by move: h2; clear; lia.
    by rewrite /left_of e4.
  by rewrite clA0 !mulr1 addrC subrK.
have B : right_of (i + k.+1) = (t (i + k.+1)%N - x) / r :: right_of (i + k).
  rewrite /right_of; have -> : (i + k.+1 - s = (i + k - s) + 1)%N by move: h2; clear; lia.
  rewrite iotaD rev_cat map_cat /=; congr (_ :: _); congr ((t _ - x) / r); move: h2; clear; lia.
rewrite addSnnS L B clE -L -B; have a0 := left_ge h; have b0 := right_gt h2.
have e : t (i + k.+1)%N - x = r * ((t (i + k.+1)%N - x) / r) by rewrite mulrC divfK // gt_eqF.
rewrite /mw /mob e; move: b0 a0; move: ((_ - _) / r) (x - t i) (cl _ _) (cl _ _) => b a u v b0 a0.
have n1 : a + b != 0 by rewrite gt_eqF // ltr_paddl. have n2 : r != 0 by rewrite gt_eqF.
have n3 : r * a + r * b != 0 by rewrite -mulrDr mulf_neq0.
by field; rewrite ?n1 ?n2 ?n3.
Qed.
(* G_0^k as the difference of the chances without the last knot and without the first *)
Theorem G_chances k : G (wt r t) t k 0 x = cl (left_of 0) (right_of k) - cl (left_of 1) (right_of k.+1).
Proof. by rewrite (G_P r t_mono k 0 hx) piece_chance !chance_cl add0n add1n. Qed.
Lemma left_all i : all (fun a => 0 <= a) (left_of i).
Proof. apply/allP => y /mapP[l]; rewrite mem_iota => h ->; apply: left_ge; move: h; clear; lia. Qed.
Lemma right_all e : all (fun b => 0 < b) (right_of e).
Proof. by apply/allP => y /mapP[l]; rewrite mem_rev mem_iota => /andP[h _] ->; apply: right_gt. Qed.
End Chances.
