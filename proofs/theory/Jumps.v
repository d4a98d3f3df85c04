(* Rem3.1 and the core of abstract.regularity: the jump of the derivative at a simple knot, in closed form. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Algebra.
Variable R : comRingType.
Variables (w dw : nat -> nat -> R) (p : nat).
(* at the knot s = p+1: intervals that end there have weight 1, those that begin there 0 *)
Hypothesis w1 : forall e j, (j <= p)%N -> (p < j + e <= p + 1)%N -> w e j = 1.
Hypothesis w0 : forall e j, (p < j <= p + 1)%N -> (p + 1 < j + e)%N -> w e j = 0.
Definition J k i : R := dN w dw p.+1 k i - dN w dw p k i.
Lemma J_step k i : (0 < k)%N -> J k.+1 i = w k.+1 i * J k i + (1 - w k.+1 i.+1) * J k i.+1.
Proof.
move=> k0; rewrite /J !dNS.
have c i' : N w p k i' = N w p.+1 k i' by rewrite -[p.+1]addn1; apply: N_cont.
by rewrite !c; ring.
Qed.
Lemma J1_s : J 1 p.+1 = dw 1%N p.+1.
Proof.
rewrite /J /= eqxx; have -> : (p.+2 == p.+1) = false by apply/eqP; lia.
have -> : (p.+1 == p) = false by apply/eqP; lia.
have -> : (p.+2 == p) = false by apply/eqP; lia.
by rewrite /= ?mulr0n ?mulr1n; ring.
Qed.
Lemma J1_p : J 1 p = - dw 1%N p - dw 1%N p.+1.
Proof.
rewrite /J /= !eqxx; have -> : (p == p.+1) = false by apply/eqP; lia.
have -> : (p.+1 == p) = false by apply/eqP; lia.
by rewrite /= ?mulr0n ?mulr1n; ring.
Qed.
Lemma J1_out i : (p.+1 < i)%N -> J 1 i = 0.
Proof.
move=> h; rewrite /J /=; have -> : (i == p.+1) = false by apply/eqP; lia.
have -> : (i.+1 == p.+1) = false by apply/eqP; lia.
have -> : (i == p) = false by apply/eqP; lia.
have -> : (i.+1 == p) = false by apply/eqP; lia.
by rewrite /= ?mulr0n ?mulr1n; ring.
Qed.
Lemma J_out k i : (p < i)%N -> J k.+2 i = 0.
Proof.
elim: k i => [|k IH] i h; last by rewrite J_step // !IH ?mulr0 ?addr0 //; lia.
rewrite J_step // [J 1 i.+1]J1_out ?mulr0 ?addr0; last lia.
case: (ltnP p.+1 i) => e; first by rewrite J1_out ?mulr0.
by rewrite w0 ?mul0r //; lia.
Qed.
(* the row k = 2 *)
Lemma J2_p : J 2 p = dw 1%N p.+1 - w 2%N p * (dw 1%N p + dw 1%N p.+1).
Proof. by rewrite J_step // J1_s J1_p (w0 (e := 2) (j := p.+1)) ?subr0; [ring|lia|lia]. Qed.
Theorem J_p k : J k.+2 p = J 2 p * \prod_(3 <= e < k.+3) w e p.
Proof.
elim: k => [|k IH]; first by rewrite big_geq // mulr1.
by rewrite J_step // [J k.+2 p.+1]J_out // mulr0 addr0 IH [in RHS]big_nat_recr // mulrCA; congr (_ * _); rewrite mulrC.
Qed.
End Algebra.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variable p : nat.                        (* the simple knot is t_(p+1) *)
Hypothesis hL : t p < t p.+1.
Hypothesis hR : t p.+1 < t p.+2.
Let y := t p.+1.

Lemma wy1 e j : (j <= p)%N -> (p < j + e <= p + 1)%N -> mw r t e j y = 1.
Proof.
move=> h1 h2; have e1 : (j + e = p.+1)%N by lia.
by rewrite /mw e1 mob_b // (le_lt_trans (tle h1) hL).
Qed.
Lemma wy0 e j : (p < j <= p + 1)%N -> (p + 1 < j + e)%N -> mw r t e j y = 0.
Proof. by move=> h1 h2; have -> : (j = p.+1)%N by [lia]; rewrite /mw mob_a. Qed.

(* jump of the derivative of G_p^k at t_(p+1): right minus left *)
Theorem Rem3_1_jump k : dP r t p.+1 k.+2 p y - dP r t p k.+2 p y =
  (r - 1) / (r * (y - t p) + (t p.+2 - y)) * \prod_(3 <= e < k.+3) mob r y (t p) (t (p + e)%N).
Proof.
have := @J_p R (fun d j => mw r t d j y) (fun d j => dmw r t d j y) p wy1 wy0 k.
rewrite (@J2_p R (fun d j => mw r t d j y) (fun d j => dmw r t d j y) p wy1 wy0) {1}/J.
rewrite -/(dP r t p.+1 k.+2 p y) -/(dP r t p k.+2 p y) => ->; congr (_ * _).
rewrite /dmw /mw !addn1 addn2 dmob_a // (dmob_b r_gt0 hL) /mob -/y.
have e1 : y - t p != 0 by rewrite subr_eq0 gt_eqF.
have e2 : t p.+2 - y != 0 by rewrite subr_eq0 gt_eqF.
have e3 : r != 0 by rewrite gt_eqF.
have e4 := mob_den_neq0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR); rewrite -/y in e4.
by field; rewrite e1 e2 e3 e4.
Qed.
Lemma mob_in e : (3 <= e)%N -> 0 < mob r y (t p) (t (p + e)%N).
Proof.
move=> h; apply: mob_gt0 => //; apply: tle; lia.
Qed.
(* Rem3.1: not C^1 at any simple knot, every degree k >= 2, r <> 1 *)
Theorem Rem3_1 k : r != 1 -> ~ exists l v, left_taylor (G (wt r t) t k.+2 p) y v l /\ right_taylor (G (wt r t) t k.+2 p) y v l.
Proof.
move=> r1 [l [v [h1 h2]]].
have [|_ e1] := left_taylor_unique h1 (@G_left _ _ r_gt0 t t_mono p k.+2 p y _); first by rewrite hL lexx.
have [|_ e2] := right_taylor_unique h2 (@G_right _ _ r_gt0 t t_mono p.+1 k.+2 p y _); first by rewrite lexx hR.
have := Rem3_1_jump k; rewrite -e1 -e2 subrr => /esym/eqP.
rewrite mulf_eq0 mulf_eq0 subr_eq0 (negbTE r1) /= invr_eq0.
rewrite (negbTE (mob_den_neq0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR))) /=.
apply/negP; rewrite gt_eqF // big_nat_cond; apply: prodr_gt0 => e /andP[/andP[h _] _].
exact: mob_in.
Qed.
(* and the jump is at most |r-1| / (r h_0 + h_1): it vanishes with r - 1 *)
Theorem Rem3_1_bound k : `|dP r t p.+1 k.+2 p y - dP r t p k.+2 p y| <= `|r - 1| / (r * (y - t p) + (t p.+2 - y)).
Proof.
have D := mob_den_gt0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR).
rewrite Rem3_1_jump normrM normf_div (gtr0_norm D).
rewrite -[X in _ <= X]mulr1 ler_wpmul2l //; first by rewrite divr_ge0 // ltW.
have h e : (3 <= e)%N -> 0 <= mob r y (t p) (t (p + e)%N) <= 1.
  move=> e3; rewrite (ltW (mob_in e3)) /= ltW // mob_lt1 // ?(ltW hL) //.
  by apply: (lt_le_trans hR); apply: tle; lia.
suff /andP[a b] : 0 <= \prod_(3 <= e < k.+3) mob r y (t p) (t (p + e)%N) <= 1 by rewrite ger0_norm.
elim: k => [|k /andP[a b]]; first by rewrite big_geq // ler01 lexx.
have /andP[c d] := h k.+3 isT; rewrite big_nat_recr //= mulr_ge0 //=.
by rewrite -[X in _ <= X]mulr1 ler_pmul.
Qed.
End Paper.

Print Assumptions Rem3_1_jump.
Print Assumptions Rem3_1.
Print Assumptions Rem3_1_bound.
