(* Lost regularity: at a knot of any multiplicity q < k the derivative of one function jumps by
   q (r-1)/(r h_0 + h_1) times a product of weights, h_0 and h_1 the spans on both sides. So it jumps exactly if r <> 1. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Algebra.
Variable R : comRingType.
Lemma dN_ext (w w' dw dw' : nat -> nat -> R) s k i :
  (forall e j, (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> w e j = w' e j /\ dw e j = dw' e j) ->
  N w s k i = N w' s k i /\ dN w dw s k i = dN w' dw' s k i.
Proof.
elim: k i => [|k IH] i h //.
have [n0 d0] : N w s k i = N w' s k i /\ dN w dw s k i = dN w' dw' s k i.
  by apply: IH => e j *; apply: h => //; apply: leqW.
have [n1 d1] : N w s k i.+1 = N w' s k i.+1 /\ dN w dw s k i.+1 = dN w' dw' s k i.+1.
  by apply: IH => e j *; apply: h => //; [apply: ltnW|apply: leqW].
rewrite !NS !dNS n0 n1 d0 d1.
case: (boolP (i <= s <= i + k)%N) => e; case: (boolP (i.+1 <= s <= i.+1 + k)%N) => e'.
- have [-> ->] := h k.+1 i (leqnn i) ltac:(move: e; clear; lia) (leqnn _).
  by have [-> ->] := h k.+1 i.+1 (leqnSn i) ltac:(move: e'; clear; lia) (leqnn _).
- have [-> ->] := h k.+1 i (leqnn i) ltac:(move: e; clear; lia) (leqnn _).
  by rewrite [N w' s k i.+1]N_supp // [dN _ _ s k i.+1]dN_supp // !mulr0.
- have [-> ->] := h k.+1 i.+1 (leqnSn i) ltac:(move: e'; clear; lia) (leqnn _).
  by rewrite [N w' s k i]N_supp // [dN _ _ s k i]dN_supp // !mulr0.
by rewrite ![N w' s k _]N_supp // ![dN _ _ s k _]dN_supp // !mulr0.
Qed.

Variables (w dw : nat -> nat -> R) (p q : nat).
Hypothesis q0 : (0 < q)%N.
(* the knots p+1..p+q coincide: intervals that end there have weight 1, those that begin there 0 *)
Hypothesis w1 : forall e j, (j <= p)%N -> (p < j + e <= p + q)%N -> w e j = 1.
Hypothesis w0 : forall e j, (p < j <= p + q)%N -> (p + q < j + e)%N -> w e j = 0.
Definition J k i : R := dN w dw (p + q) k i - dN w dw p k i.
Lemma J_step k i : (q <= k)%N -> J k.+1 i = w k.+1 i * J k i + (1 - w k.+1 i.+1) * J k i.+1.
Proof.
move=> qk; rewrite /J !dNS.
have c i' : N w p k i' = N w (p + q) k i' by apply: N_cont.
by rewrite !c; ring.
Qed.
Definition A := \sum_(1 <= e < q.+1) dw e (p + q - e).+1.
Definition B := \sum_(1 <= e < q.+1) dw e p.
Lemma dN_right i : (p <= i)%N -> dN w dw (p + q) q i = ((i + q == (p + q).+1)%N%:R - (i + q == p + q)%N%:R) * A.
Proof.
move=> pi; pose w' e j := if (p < j)%N then w e j else 0.
have [_ ->] : N w (p + q) q i = N w' (p + q) q i /\ dN w dw (p + q) q i = dN w' dw (p + q) q i.
  by apply: dN_ext => e j h1 h2 h3; rewrite /w'; case: (ltnP p j) => // h; move: h1 h2 h3 h pi; clear; lia.
rewrite dN_start; last first.
  by move=> e j h; rewrite /w'; case: (ltnP p j) => // h1; apply: w0; move: h h1; clear; lia.
congr (_ * _); apply: eq_big_nat => e he; congr (dw _ _); move: he; clear; lia.
Qed.
Lemma dN_left : dN w dw p q p = B.
Proof.
rewrite /B; case: q q0 w1 => // d _ h1; rewrite dNS.
rewrite [N w p d p.+1]N_supp; last by clear; lia.
rewrite [dN w dw p d p.+1]dN_supp; last by clear; lia.
have s e j : (j <= p < j + e)%N -> (j + e <= p + d.+1)%N -> w e j = 1.
  by move=> hj1 hj2; apply: h1; move: hj1 hj2; clear; lia.
rewrite (N_stop s) ?(dN_stop _ s) ?eqxx ?(h1 d.+1 p) //; try (clear; lia).
have -> : (p.+1 == p) = false by apply/eqP; clear; lia.
by rewrite !mulr0 !addr0 mulr1 subr0 !mul1r [RHS]big_nat_recr //= addrC.
Qed.
Lemma J_p0 : J q p = - A - B.
Proof.
rewrite /J dN_left dN_right // eqxx; have -> : (p + q == (p + q).+1)%N = false by apply/eqP; clear; lia.
by rewrite sub0r mulN1r.
Qed.
Lemma J_p1 : J q p.+1 = A.
Proof.
rewrite /J [dN _ _ p q _]dN_supp ?dN_right //; last by clear; lia.
rewrite addSn eqxx; have -> : ((p + q).+1 == p + q)%N = false by apply/eqP; clear; lia.
by rewrite !subr0 mul1r.
Qed.
Lemma J_p2 i : (p.+1 < i)%N -> J q i = 0.
Proof.
move=> h; rewrite /J [dN _ _ p q _]dN_supp ?dN_right //; try (move: h; clear; lia).
have -> : (i + q == (p + q).+1)%N = false by apply/eqP; move: h; clear; lia.
have -> : (i + q == p + q)%N = false by apply/eqP; move: h; clear; lia.
by rewrite !subr0 mul0r.
Qed.
Lemma J_out d i : (p < i)%N -> J (q.+1 + d) i = 0.
Proof.
elim: d i => [|d IH] i h; last first.
  rewrite addnS J_step; last by clear; lia.
  by rewrite !IH ?mulr0 ?addr0 // ltnW.
rewrite addn0 J_step // [J q i.+1]J_p2 // mulr0 addr0.
case: (ltnP p.+1 i) => e; first by rewrite J_p2 ?mulr0.
by rewrite w0 ?mul0r //; move: h e q0; clear; lia.
Qed.
(* the jump in the first degree in which the function is continuous with its first derivative for equal weights *)
Theorem J_first : J q.+1 p = A - w q.+1 p * (A + B).
Proof. by rewrite J_step // J_p0 J_p1 (w0 (e := q.+1) (j := p.+1)) ?subr0; [ring|move: q0; clear; lia|clear; lia]. Qed.
(* each further degree gives one factor *)
Theorem J_p d : J (q.+1 + d) p = J q.+1 p * \prod_(q.+2 <= e < q.+2 + d) w e p.
Proof.
elim: d => [|d IH]; first by rewrite !addn0 big_geq // mulr1.
rewrite addnS J_step; last by clear; lia.
rewrite [J _ p.+1]J_out // mulr0 addr0 IH [in RHS]addnS [in RHS]big_nat_recr /=; last by clear; lia.
by rewrite mulrCA; congr (_ * _); rewrite mulrC.
Qed.
(* the same on the other side: the functions whose knots end at p+q+1 *)
Lemma J_q_low i : (i < p)%N -> J q i = (i.+1 == p)%:R * B.
Proof.
move=> h; rewrite /J [dN _ _ (p + q) q _]dN_supp ?sub0r; last by move: h; clear; lia.
have s e j : (j <= p < j + e)%N -> (j + e <= p + q)%N -> w e j = 1.
  by move=> hj1 hj2; apply: w1; move: hj1 hj2; clear; lia.
rewrite (dN_stop _ s); last by rewrite ltn_add2r.
by rewrite (ltn_eqF h) sub0r mulNr opprK.
Qed.
Lemma J_out_low d i : (i + d.+1 < p)%N -> J (q.+1 + d) i = 0.
Proof.
elim: d i => [|d IH] i h; last first.
  rewrite addnS J_step; last by clear; lia.
  by rewrite !IH ?mulr0 ?addr0 //; move: h; clear; lia.
rewrite addn0 J_step // !J_q_low; try (move: h; clear; lia).
have -> : (i.+1 == p) = false by apply/eqP; move: h; clear; lia.
rewrite mul0r mulr0 add0r; case: (eqVneq i.+2 p) => [e|_]; last by rewrite mul0r mulr0.
by rewrite w1 ?subrr ?mul0r //; move: e q0; clear; lia.
Qed.
(* the mirror image *)
Theorem J_low d : (d < p)%N -> J (q.+1 + d) (p - d.+1) = - J q.+1 p * \prod_(0 <= e < d) (1 - w (q.+2 + e)%N (p - e.+1)%N).
Proof.
elim: d => [|d IH] h.
  rewrite big_geq // mulr1 addn0 J_first J_step //.
  have -> : ((p - 1).+1 = p)%N by move: h; clear; lia.
  rewrite J_q_low; last by move: h; clear; lia.
  have -> : ((p - 1).+1 == p)%N by apply/eqP; move: h; clear; lia.
  rewrite J_p0 (w1 (e := q.+1) (j := (p - 1)%N)); [rewrite /= mulr1n; ring|clear; lia|move: h q0; clear; lia].
rewrite addnS J_step; last by clear; lia.
have -> : ((p - d.+2).+1 = p - d.+1)%N by move: h; clear; lia.
rewrite (@J_out_low d (p - d.+2)); last by move: h; clear; lia.
by rewrite mulr0 add0r IH ?(ltnW h) // [in RHS]big_nat_recr //= [LHS]mulrC -mulrA !addSn.
Qed.
End Algebra.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
(* the knot y: t_(p+1) = .. = t_(p+q), and no others *)
Variables (p q : nat) (y : R).
Hypothesis q0 : (0 < q)%N.
Hypothesis hL : t p < y.
Hypothesis hy : forall j, (p < j <= p + q)%N -> t j = y.
Hypothesis hR : y < t (p + q).+1.

Lemma wy1 e j : (j <= p)%N -> (p < j + e <= p + q)%N -> mw r t e j y = 1.
Proof. by move=> h1 h2; rewrite /mw (hy h2) mob_b // (le_lt_trans (tle h1) hL). Qed.
Lemma wy0 e j : (p < j <= p + q)%N -> (p + q < j + e)%N -> mw r t e j y = 0.
Proof. by move=> h1 h2; rewrite /mw (hy h1) mob_a. Qed.

(* the jump of the derivative of G_p^k at y, right minus left, k = q+1+d *)
Theorem jump d : dP r t (p + q) (q.+1 + d) p y - dP r t p (q.+1 + d) p y =
  q%:R * (r - 1) / (r * (y - t p) + (t (p + q).+1 - y)) * \prod_(q.+2 <= e < q.+2 + d) mob r y (t p) (t (p + e)%N).
Proof.
have := @J_p R (fun e j => mw r t e j y) (fun e j => dmw r t e j y) p q q0 wy1 wy0 d.
rewrite (@J_first R (fun e j => mw r t e j y) (fun e j => dmw r t e j y) p q q0 wy1 wy0) {1}/J.
rewrite -/(dP r t (p + q) (q.+1 + d) p y) -/(dP r t p (q.+1 + d) p y) => ->; congr (_ * _).
have EA : A (fun e j => dmw r t e j y) p q = q%:R * (r / (t (p + q).+1 - y)).
  rewrite /A (eq_big_nat _ _ (F2 := fun _ => r / (t (p + q).+1 - y))).
    by rewrite sumr_const_nat subSS subn0 mulr_natl.
  move=> e he; rewrite /dmw hy; last by move: he; clear; lia.
  have -> : ((p + q - e).+1 + e = (p + q).+1)%N by move: he; clear; lia.
  by rewrite dmob_a.
have EB : B (fun e j => dmw r t e j y) p q = q%:R * (r^-1 / (y - t p)).
  rewrite /B (eq_big_nat _ _ (F2 := fun _ => r^-1 / (y - t p))).
    by rewrite sumr_const_nat subSS subn0 mulr_natl.
  by move=> e he; rewrite /dmw (@hy (p + e)%N) ?dmob_b //; move: he; clear; lia.
rewrite EA EB /mw /mob addnS.
have e1 : y - t p != 0 by rewrite subr_eq0 gt_eqF.
have e2 : t (p + q).+1 - y != 0 by rewrite subr_eq0 gt_eqF.
have e3 : r != 0 by rewrite gt_eqF.
have e4 := mob_den_neq0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR).
move: (q%:R : R) => Q; by field; rewrite e1 e2 e3 e4.
Qed.
Lemma mob_in e : (q.+1 < e)%N -> 0 < mob r y (t p) (t (p + e)%N).
Proof.
move=> h; apply: mob_gt0 => //; apply: (le_trans (ltW hR)); apply: tle; move: h; clear; lia.
Qed.
(* it is not 0 exactly if r <> 1 *)
Theorem jump_neq0 d : (dP r t p (q.+1 + d) p y != dP r t (p + q) (q.+1 + d) p y) = (r != 1).
Proof.
have D := mob_den_neq0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR).
have pr : \prod_(q.+2 <= e < q.+2 + d) mob r y (t p) (t (p + e)%N) != 0.
  by rewrite gt_eqF // big_nat_cond; apply: prodr_gt0 => e /andP[/andP[h _] _]; apply: mob_in.
rewrite eq_sym -subr_eq0 jump !mulf_eq0 (negbTE pr) invr_eq0 (negbTE D) !orbF pnatr_eq0 subr_eq0.
by rewrite (gtn_eqF q0).
Qed.
(* so G_p^k has no derivative at y *)
Theorem no_derivative d : r != 1 ->
  ~ exists l v, left_taylor (G (wt r t) t (q.+1 + d) p) y v l /\ right_taylor (G (wt r t) t (q.+1 + d) p) y v l.
Proof.
move=> r1 [l [v [h1 h2]]].
have e1 : y = t p.+1 by rewrite hy //; move: q0; clear; lia.
have e2 : y = t (p + q)%N by rewrite hy //; move: q0; clear; lia.
have [|_ d1] := left_taylor_unique h1 (@G_left _ _ r_gt0 t t_mono p (q.+1 + d) p y _); first by rewrite hL e1 lexx.
have [|_ d2] := right_taylor_unique h2 (@G_right _ _ r_gt0 t t_mono (p + q) (q.+1 + d) p y _); first by rewrite -e2 lexx hR.
by have := jump_neq0 d; rewrite -d1 -d2 eqxx r1.
Qed.
(* and the jump is at most q |r-1| / (r h_0 + h_1): it vanishes with r - 1 *)
Theorem jump_bound d : `|dP r t (p + q) (q.+1 + d) p y - dP r t p (q.+1 + d) p y| <=
  q%:R * `|r - 1| / (r * (y - t p) + (t (p + q).+1 - y)).
Proof.
have D := mob_den_gt0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR).
rewrite jump normrM normf_div (gtr0_norm D) normrM normr_nat.
rewrite -[X in _ <= X]mulr1 ler_wpmul2l //; first by rewrite divr_ge0 ?mulr_ge0 ?ler0n // ltW.
have h e : (q.+1 < e)%N -> 0 <= mob r y (t p) (t (p + e)%N) <= 1.
  move=> e3; rewrite (ltW (mob_in e3)) /= ltW // mob_lt1 // ?(ltW hL) //.
  by apply: (lt_le_trans hR); apply: tle; move: e3; clear; lia.
suff /andP[a b] : 0 <= \prod_(q.+2 <= e < q.+2 + d) mob r y (t p) (t (p + e)%N) <= 1 by rewrite ger0_norm.
elim: d => [|d /andP[a b]]; first by rewrite addn0 big_geq // ler01 lexx.
have /andP[c e] := h (q.+2 + d)%N ltac:(clear; lia); rewrite addnS big_nat_recr /=; last by clear; lia.
by rewrite mulr_ge0 //= -[X in _ <= X]mulr1 ler_pmul.
Qed.
(* the mirror image of G_p^k: G_(p+q-k)^k jumps as well *)
Theorem jump_low_neq0 d : (d < p)%N ->
  (dP r t p (q.+1 + d) (p - d.+1) y != dP r t (p + q) (q.+1 + d) (p - d.+1) y) = (r != 1).
Proof.
move=> dp; have D := mob_den_neq0 r_gt0 (ltW hL) (ltW hR) (lt_trans hL hR).
have E := @J_low R (fun e j => mw r t e j y) (fun e j => dmw r t e j y) p q q0 wy1 wy0 d dp.
have E1 := jump_neq0 0; rewrite addn0 in E1.
rewrite -E1 eq_sym -subr_eq0 -/(J (fun e j => mw r t e j y) (fun e j => dmw r t e j y) p q (q.+1 + d) (p - d.+1)) E.
rewrite mulf_eq0 oppr_eq0 [J _ _ _ _ _ _]/J subr_eq0 [_ == dN _ _ p _ _]eq_sym.
suff /negbTE -> : \prod_(0 <= e < d) (1 - mw r t (q.+2 + e) (p - e.+1) y) != 0 by rewrite orbF.
rewrite gt_eqF // big_nat_cond; apply: prodr_gt0 => e /andP[/andP[_ h] _].
have E2 : (p - e.+1 + (q.+2 + e) = (p + q).+1)%N by move: h dp; clear; lia.
by rewrite subr_gt0 /mw E2 mob_lt1 // (le_trans _ (ltW hL)) // tle // leq_subr.
Qed.
End Paper.
