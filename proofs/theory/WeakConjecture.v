(* Conjecture 3.1 fails in its weak form too, for every degree k >= 3 and every r <> 1: there are knots on which the largest value of G_0^k is
   taken at two points. The knots of TwoMaxima.v, 0 (k-1 times), 1, 1+e, 1+e+c, move along a segment on which the jump of the derivative at
   the knot 1 stays positive. At its one end G_0^k does not rise after 1, at the other it does not fall before 1; "a value at most 1 is as large as every
   value from 1 on" is a first-order sentence, so that it changes its truth somewhere between (Definable.v), and there the largest values on both sides are equal
   and greater than that at 1. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify polyrcf ordered_qelim qe_rcf.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis TwoMaxima Cumulative Minors RationalDerivative Theorem3 MaximaBound Definable.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- the segment ---- *)
Section Slopes.
Variable R : realFieldType.
Variables (rho : R) (d : nat).
Hypothesis rho0 : 0 < rho.
Let m : R := d.+1%:R.
Let p0 : R := m / (m + 1).
Let m0 : 0 < m. Proof. by rewrite ltr0n. Qed.
Let m1 : 0 < m + 1. Proof. by rewrite addr_gt0 ?ltr01. Qed.
Let p00 : 0 < p0. Proof. by rewrite divr_gt0. Qed.
Definition Py (y h : R) : R := p0 + (- ((1 - y) / 2%:R)) * h.
Definition Qy (y h : R) : R := p0 + ((1 + y) / 2%:R) * h.
Lemma tslope y s : exists v l, taylor (fun h => s * SS (Py y h) (Qy y h) d + E rho (Py y h) (Qy y h) d.+1) 0 v l /\ v = 0 /\
  l = p0 ^+ d.+1 / p0 ^+ 2 / (m + 1) ^+ 2 * (m / 2%:R) * ((rho - 1) * m + (rho + m + s) * (m + 1) * y).
Proof.
have pn : p0 != 0 by rewrite gt_eqF.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0. have six : 6%:R != 0 :> R by rewrite pnatr_eq0.
have tP : taylor (Py y) 0 p0 (- ((1 - y) / 2%:R)) by exact: taylor_line.
have tQ : taylor (Qy y) 0 p0 ((1 + y) / 2%:R) by exact: taylor_line.
have hS := taylor_scale s (tSS pn tP tQ d).
have [v [l [hE [ev el]]]] := tE pn tP tQ rho d.+1.
have mn : m != 0 by rewrite gt_eqF. have m1n : m + 1 != 0 by rewrite gt_eqF.
do 2 eexists; split; [exact: (taylor_add hS hE)|split].
  rewrite ev -[d.+2]addn1 natrD -/m exprS /ff /p0.
  move: ((m / (m + 1)) ^+ d) => X; field; rewrite ?m1n ?mn //.
rewrite {}el -[d.+2]addn1 natrD -/m !exprS /ff /p0.
have -> : d%:R = m - 1 by rewrite /m -[d.+1]addn1 natrD addrK.
move: ((m / (m + 1)) ^+ d) => X; field; rewrite ?m1n ?mn ?two ?six //.
Qed.
Lemma tjump y : taylor (fun h => SS (Py y h) (Qy y h) d) 0 0 (p0 ^+ d / 2%:R * y).
Proof.
have pn : p0 != 0 by rewrite gt_eqF. have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
have tP : taylor (Py y) 0 p0 (- ((1 - y) / 2%:R)) by exact: taylor_line.
have tQ : taylor (Qy y) 0 p0 ((1 + y) / 2%:R) by exact: taylor_line.
have mn : m != 0 by rewrite gt_eqF. have m1n : m + 1 != 0 by rewrite gt_eqF.
apply: taylor_eq (tSS pn tP tQ d) _ _.
  rewrite -[d.+2]addn1 natrD -/m exprS /p0; move: ((m / (m + 1)) ^+ d) => X; field; rewrite ?m1n ?mn //.
rewrite -[d.+2]addn1 natrD -/m exprS /p0.
have -> : d%:R = m - 1 by rewrite /m -[d.+1]addn1 natrD addrK.
move: ((m / (m + 1)) ^+ d) => X; field; rewrite ?m1n ?mn ?two //.
Qed.
(* two numbers y: in the one direction D+ is negative, in the other D- positive, and between them the jump does not change its sign *)
Lemma two_directions : rho != 1 -> exists y1 y2, [/\ y1 < y2, -1 <= y1, (rho - 1) * m + (rho + m + 1) * (m + 1) * y1 < 0,
  0 < (rho - 1) * m + (rho + m + rho) * (m + 1) * y2 & (0 < 1 - rho /\ 0 < y1) \/ (1 - rho < 0 /\ y2 < 0)].
Proof.
move=> r1; have A0 : 0 < (rho + m + 1) * (m + 1) by rewrite mulr_gt0 // !addr_gt0 ?ltr01.
have B0 : 0 < (rho + m + rho) * (m + 1) by rewrite mulr_gt0 // !addr_gt0.
set A := (rho + m + 1) * (m + 1) in A0 *; set B := (rho + m + rho) * (m + 1) in B0 *.
have An : A != 0 by rewrite gt_eqF. have Bn : B != 0 by rewrite gt_eqF. have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
have A2 : 0 < 2%:R * A by rewrite pmulr_rgt0 ?ltr0n. have B2 : 0 < 2%:R * B by rewrite pmulr_rgt0 ?ltr0n.
case: (ltgtP rho 1) r1 => // c _.
  have r0 : 0 < 1 - rho by rewrite subr_gt0. have c0 : 0 < (1 - rho) * m by rewrite mulr_gt0.
  have AB : B < A by rewrite /A /B ltr_pmul2r // ltr_add2l.
  exists ((1 - rho) * m / (2%:R * A)), ((1 - rho) * m * 2%:R / B); split.
  - apply: (@lt_trans _ _ ((1 - rho) * m / B)).
      rewrite ltr_pmul2l // ltf_pinv ?posrE //; apply: (lt_trans AB).
      by rewrite ltr_pmull // ltr1n.
    by rewrite ltr_pmul2r ?invr_gt0 // ltr_pmulr // ltr1n.
  - by apply: (@le_trans _ _ 0); rewrite ?lerN10 // ltW // divr_gt0.
  - have -> : (rho - 1) * m + A * ((1 - rho) * m / (2%:R * A)) = - ((1 - rho) * m / 2%:R) by field; rewrite ?An ?two.
    by rewrite oppr_lt0 divr_gt0 ?ltr0n.
  - have -> : (rho - 1) * m + B * ((1 - rho) * m * 2%:R / B) = (1 - rho) * m by field.
    exact: c0.
  by left; split => //; rewrite divr_gt0.
have r0 : 0 < rho - 1 by rewrite subr_gt0. have c0 : 0 < (rho - 1) * m by rewrite mulr_gt0.
have cB : (rho - 1) * m < B.
  rewrite /B ltr_pmul ?(ltW r0) ?(ltW m0) // ?ltr_addl ?ltr01 //.
  by rewrite ltr_subl_addr -!addrA ltr_addl !addr_gt0 // ltr01.
have cA : (rho - 1) * m < A.
  rewrite /A ltr_pmul ?(ltW r0) ?(ltW m0) // ?ltr_addl ?ltr01 //.
  by rewrite ltr_subl_addr -!addrA ltr_addl !addr_gt0 // ltr01.
exists (-1), (- ((rho - 1) * m / (2%:R * B))); split.
- rewrite ltr_opp2 ltr_pdivr_mulr // mul1r; apply: (lt_trans cB).
  by rewrite ltr_pmull // ltr1n.
- exact: lexx.
- by rewrite mulrN1 subr_lt0.
- have -> : (rho - 1) * m + B * - ((rho - 1) * m / (2%:R * B)) = (rho - 1) * m / 2%:R by field; rewrite ?Bn ?two.
  by rewrite divr_gt0 ?ltr0n.
by right; rewrite subr_lt0 oppr_lt0 divr_gt0.
Qed.
End Slopes.

Section Segment.
Variable R : rcfType.
Variable d : nat.
Let m : R := d.+1%:R.
(* along (1,1) the jump rises *)
Lemma isd_H (p q : R) u v n : isd u v (fun w => H (p + w) (q + w) n) (fun w => if n is n'.+1 then n'.+2%:R * H (p + w) (q + w) n' else 0).
Proof.
have line c : isd u v (fun w => c + w) (fun _ => 1).
  by apply: (isd_ext (isd_add (isd_const u v c) (isd_id u v))) => w _ //; rewrite add0r.
have pow e : isd u v (fun w => (p + w) ^+ e) (fun w => e%:R * (p + w) ^+ e.-1).
  elim: e => [|e IH].
    by apply: (isd_ext (isd_const u v 1)) => w _; rewrite ?expr0 ?mul0r.
  apply: (isd_ext (isd_mul (line p) IH)) => w _; first by rewrite exprS.
  case: e {IH} => [|e]; first by rewrite /= !expr0 mul0r mulr0 addr0.
  by rewrite /= -[e.+2]addn1 natrD exprS; ring.
elim: n => [|n IH].
  by apply: (isd_ext (isd_const u v 1)) => w _.
apply: (isd_ext (isd_add (pow n.+1) (isd_mul (line q) IH))) => w _; first by rewrite HS.
case: n {IH} => [|n]; first by rewrite /= expr0; ring.
by rewrite !HS [n.+2.-1]/= -[n.+3]addn1 natrD; move: (H _ _ n) ((p + w) ^+ n.+1) => X Y; ring.
Qed.
Lemma jump_rises (p q z : R) : 0 < p -> p < q -> m <= (m + 1) * q -> 0 <= z -> H p q d.+1 - H p q d <= H (p + z) (q + z) d.+1 - H (p + z) (q + z) d.
Proof.
move=> p0 pq q1 z0; have hd := isd_sub (isd_H p q (-1) (z + 1) d.+1) (isd_H p q (-1) (z + 1) d).
have := @isd_mono_seg R (-1) (z + 1) _ _ 0 z hd ltac:(by rewrite oppr_lt0 ltr01) z0 ltac:(by rewrite ltr_addl ltr01).
rewrite !addr0; apply=> w /andP[w0 _]; have P0 : 0 < p + w by rewrite ltr_paddr. have Q0 : 0 < q + w by rewrite ltr_paddr // (lt_trans p0).
have H0 n : 0 <= H (p + w) (q + w) n.
  by elim: n => [|n IH] /=; rewrite ?ler01 // addr_ge0 ?mulr_ge0 ?exprn_ge0 // ltW.
case: (d) @m q1 => [|e] /=; first by move=> _; rewrite subr0 mulr1 ler0n.
rewrite -[e.+2]/(e.+1.+1) => q1.
have -> : e.+3%:R * (((p + w) ^+ e.+1) + (q + w) * H (p + w) (q + w) e) - e.+2%:R * H (p + w) (q + w) e =
   e.+3%:R * (p + w) ^+ e.+1 + ((e.+2%:R + 1) * q - e.+2%:R + (e.+2%:R + 1) * w) * H (p + w) (q + w) e.
  by rewrite -[e.+3]addn1 natrD; ring.
rewrite addr_ge0 // ?mulr_ge0 ?ler0n ?exprn_ge0 ?(ltW P0) // addr_ge0 ?subr_ge0 // mulr_ge0 // addr_ge0 ?ler0n ?ler01 //.
Qed.
(* the segment: D+ negative at its begin, D- positive at its end, and (1 - rho) S positive along it *)
Lemma segment (rho : R) : 0 < rho -> rho != 1 -> exists p q L, [/\ 0 < p, p < q, 0 < L, q + L < 1 &
  [/\ SS p q d + E rho p q d.+1 < 0, 0 < rho * SS (p + L) (q + L) d + E rho (p + L) (q + L) d.+1 &
      forall h, 0 <= h -> h <= L -> 0 < (1 - rho) * SS (p + h) (q + h) d]].
Proof.
move=> rho0 rho1; have [y1 [y2 [y12 y1m B A sg]]] := two_directions d rho0 rho1.
have m0 : 0 < m by rewrite ltr0n. have m1 : 0 < m + 1 by rewrite addr_gt0 ?ltr01.
pose p0 := m / (m + 1); have p00 : 0 < p0 by rewrite divr_gt0.
have p01 : p0 < 1 by rewrite ltr_pdivr_mulr // mul1r ltr_addl ltr01.
have p01' : 0 < 1 - p0 by rewrite subr_gt0.
have c0 : 0 < p0 ^+ d.+1 / p0 ^+ 2 / (m + 1) ^+ 2 * (m / 2%:R) by rewrite mulr_gt0 ?divr_gt0 ?exprn_gt0 ?ltr0n.
have [v1 [l1 [h1 [ev1 el1]]]] := tslope rho d y1 1; have [v2 [l2 [h2 [ev2 el2]]]] := tslope rho d y2 rho.
have h1' := taylor_scale (-1) h1; rewrite ev1 mulr0 in h1'; rewrite ev2 in h2.
have s1 : 0 < -1 * l1 by rewrite mulN1r oppr_gt0 el1 pmulr_rlt0.
have s2 : 0 < l2 by rewrite el2 pmulr_rgt0.
have [e1 e10 H1] := taylor_pos h1' (or_intror (conj erefl s1)).
have [e2 e20 H2] := taylor_pos h2 (or_intror (conj erefl s2)).
have line c a : taylor (fun h : R => c + a * h) 0 c a by exact: taylor_line.
have [e3 e30 H3] := taylor_pos (line p0 (- ((1 - y1) / 2%:R))) (or_introl p00).
have [e4 e40 H4] := taylor_pos (taylor_1sub (line p0 ((1 + y2) / 2%:R))) (or_introl p01').
(* the sign of the jump at one end *)
have [e5 e50 H5] : exists2 e, 0 < e & forall h, 0 < h < e ->
    (0 < 1 - rho /\ 0 < SS (Py d y1 h) (Qy d y1 h) d) \/ (1 - rho < 0 /\ SS (Py d y2 h) (Qy d y2 h) d < 0).
  have P0 : 0 < p0 ^+ d / 2%:R by rewrite divr_gt0 ?exprn_gt0 ?ltr0n.
  case: sg => [[r0 yp]|[r0 yn]].
    have [e e0 H] := taylor_pos (tjump d y1) (or_intror (conj erefl (mulr_gt0 P0 yp))).
    by exists e => // h hh; left; split => //; apply: H.
  have t := taylor_scale (-1) (tjump d y2); rewrite mulr0 in t.
  have s3 : 0 < -1 * (p0 ^+ d / 2%:R * y2) by rewrite mulN1r oppr_gt0 pmulr_rlt0.
  have [e e0 H] := taylor_pos t (or_intror (conj erefl s3)).
  by exists e => // h hh; right; split => //; rewrite -oppr_gt0 -mulN1r; apply: H.
have [h [hp [a1 a2 a3 a4 a5]]] : exists h, 0 < h /\ [/\ h < e1, h < e2, h < e3, h < e4 & h < e5].
  have M0 : 0 < Num.min (Num.min e1 e2) (Num.min (Num.min e3 e4) e5) by rewrite !lt_minr e10 e20 e30 e40.
  have : 0 < Num.min (Num.min e1 e2) (Num.min (Num.min e3 e4) e5) / 2%:R < Num.min (Num.min e1 e2) (Num.min (Num.min e3 e4) e5).
    by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
  by move=> /andP[k0]; rewrite !lt_minr => /andP[/andP[k1 k2] /andP[/andP[k3 k4] k5]]; eexists; split; [exact: k0|split].
have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
pose L := (y2 - y1) / 2%:R * h; have L0 : 0 < L by rewrite mulr_gt0 // divr_gt0 ?ltr0n // subr_gt0.
have eP : Py d y2 h = Py d y1 h + L by rewrite /Py /L -/m -/p0; field.
have eQ : Qy d y2 h = Qy d y1 h + L by rewrite /Qy /L -/m -/p0; field.
have pp : 0 < Py d y1 h by apply: H3; rewrite hp.
have q1 : Qy d y1 h + L < 1 by rewrite -eQ -subr_gt0; apply: H4; rewrite hp.
have pq : Py d y1 h < Qy d y1 h.
  rewrite /Py /Qy ltr_add2l ltr_pmul2r // -subr_gt0.
  by have -> : (1 + y1) / 2%:R - - ((1 - y1) / 2%:R) = 1 by field.
have qm : m <= (m + 1) * Qy d y1 h.
  have q0 : p0 <= Qy d y1 h.
    by rewrite /Qy -/m -/p0 ler_addl mulr_ge0 ?(ltW hp) // divr_ge0 ?ler0n // -ler_subl_addl sub0r.
  by rewrite mulrC -ler_pdivr_mulr.
exists (Py d y1 h), (Qy d y1 h), L; split=> //; split.
- by rewrite -oppr_gt0 -mulN1r -[X in X + _]mul1r; apply: H1; rewrite hp.
- by rewrite -eP -eQ; apply: H2; rewrite hp.
move=> z z0 zL; have q2 : Qy d y1 h + z < 1 by apply: le_lt_trans q1; rewrite ler_add2l.
have p2 : 0 < 1 - (Py d y1 h + z) by rewrite subr_gt0 (lt_trans _ q2) // ltr_add2r.
have pl : 0 < 1 - (Py d y1 h + L) by rewrite subr_gt0 (lt_trans _ q1) // ltr_add2r.
have pl0 : 0 < 1 - Py d y1 h by rewrite subr_gt0 (lt_trans pq) // (lt_trans _ q1) // ltr_addl.
case: (H5 h ltac:(by rewrite hp)) => -[r0]; rewrite /SS ?eP ?eQ.
  rewrite pmulr_rgt0 // => s0; rewrite !mulr_gt0 //; apply: (lt_le_trans s0).
  exact: jump_rises.
rewrite pmulr_rlt0 // => s0; rewrite nmulr_rgt0 // pmulr_rlt0 //; apply: le_lt_trans s0.
have E a : a + L = a + z + (L - z) by ring.
rewrite !E; apply: jump_rises; rewrite ?subr_ge0 // ?ltr_add2r //; first by rewrite ltr_paddr.
by rewrite (le_trans qm) // ler_pmul2l // ler_addl.
Qed.
End Segment.

(* ---- a piece has a largest value on its closed span ---- *)
Section Largest.
Variable R : rcfType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables k i s : nat.
Hypothesis k0 : (0 < k)%N.
Hypothesis hs : (i <= s <= i + k)%N.
Hypothesis ss : t s < t s.+1.
Local Notation F := (P r t s k i).
(* a bound inside of the span is one on the closed span *)
Lemma closed_bound x M : t s <= x <= t s.+1 -> (exists2 e, 0 < e & forall z, t s < z < t s.+1 -> `|z - x| < e -> F z <= M) -> F x <= M.
Proof.
move=> hx [e e0 H]; rewrite leNgt; apply/negP => c.
have [d d0 Hd] := taylor_above (P_taylor r_gt0 t_mono k i ss hx) c; have /andP[x0 x1] := hx.
case: (ltP x (t s.+1)) => xs.
  have [g [g0 g1 g2]] := small2 d0 e0; have [g' [g0' g1' g2']] := small2 g0 (b := t s.+1 - x) ltac:(by rewrite subr_gt0).
  have := H (x + g') ltac:(by rewrite (le_lt_trans x0) ?ltr_addl //= addrC -ltr_subr_addr) ltac:(by rewrite addrAC subrr add0r gtr0_norm // (lt_trans g1')).
  by rewrite leNgt Hd ?gt_eqF // gtr0_norm // (lt_trans g1').
have [g [g0 g1 g2]] := small2 d0 e0; have [g' [g0' g1' g2']] := small2 g0 (b := x - t s) ltac:(by rewrite subr_gt0 (lt_le_trans ss)).
have := H (x - g') ltac:(by rewrite ltr_subr_addr addrC -ltr_subr_addr g2' (lt_le_trans _ x1) // ltr_subl_addr ltr_addl) ltac:(by rewrite addrAC subrr add0r normrN gtr0_norm // (lt_trans g1')).
by rewrite leNgt Hd ?oppr_eq0 ?gt_eqF // normrN gtr0_norm // (lt_trans g1').
Qed.
Lemma closed_above x M : t s <= x <= t s.+1 -> (exists2 e, 0 < e & forall z, t s < z < t s.+1 -> `|z - x| < e -> M <= F z) -> M <= F x.
Proof.
move=> hx [e e0 H]; rewrite leNgt; apply/negP => c.
have T := taylor_scale (-1) (P_taylor r_gt0 t_mono k i ss hx); have c' : - M < -1 * F x by rewrite mulN1r ltr_opp2.
have [d d0 Hd] := taylor_above T c'; have /andP[x0 x1] := hx.
case: (ltP x (t s.+1)) => xs.
  have [g [g0 g1 g2]] := small2 d0 e0; have [g' [g0' g1' g2']] := small2 g0 (b := t s.+1 - x) ltac:(by rewrite subr_gt0).
  have := H (x + g') ltac:(by rewrite (le_lt_trans x0) ?ltr_addl //= addrC -ltr_subr_addr) ltac:(by rewrite addrAC subrr add0r gtr0_norm // (lt_trans g1')).
  by rewrite leNgt -ltr_opp2 -[X in _ < X]mulN1r Hd ?gt_eqF // gtr0_norm // (lt_trans g1').
have [g [g0 g1 g2]] := small2 d0 e0; have [g' [g0' g1' g2']] := small2 g0 (b := x - t s) ltac:(by rewrite subr_gt0 (lt_le_trans ss)).
have := H (x - g') ltac:(by rewrite ltr_subr_addr addrC -ltr_subr_addr g2' (lt_le_trans _ x1) // ltr_subl_addr ltr_addl) ltac:(by rewrite addrAC subrr add0r normrN gtr0_norm // (lt_trans g1')).
by rewrite leNgt -ltr_opp2 -[X in _ < X]mulN1r Hd ?oppr_eq0 ?gt_eqF // normrN gtr0_norm // (lt_trans g1').
Qed.
Lemma span_max : exists2 x, t s <= x <= t s.+1 & forall y, t s <= y <= t s.+1 -> F y <= F x.
Proof.
have [N' hN] := G_rational r_gt0 t_mono k i s; have [A [B hAB]] := hN.
pose n := A^`() * B - A * B^`().
have E x : t s < x < t s.+1 -> G (wt r t) t k i x = F x.
  by move=> /andP[x0 x1]; apply: G_P => //; rewrite (ltW x0).
have hF : isd (t s) (t s.+1) F N' by apply: (isd_ext hN) => x hx //; rewrite E.
have sg x : t s < x < t s.+1 -> exists2 c, 0 < c & N' x = n.[x] * c.
  move=> hx; have [b0 _ ->] := hAB x hx; exists ((B.[x] ^+ 2)^-1); last by rewrite /n !hE.
  by rewrite invr_gt0 exprn_even_gt0.
have T3 x y : t s < x -> x < y -> y < t s.+1 -> N' x <= 0 -> N' y < 0 by apply: (paper_theorem3 r_gt0 t_mono k0 hs hN).
pose c := (t s + t s.+1) / 2%:R; have /andP[c1 c2] : t s < c < t s.+1 by rewrite !midf_lt.
have zero z : t s < z < t s.+1 -> N' z = 0 -> exists2 x, t s <= x <= t s.+1 & forall y, t s <= y <= t s.+1 -> F y <= F x.
  move=> /andP[z1 z2] Nz; exists z => [|y hy]; first by rewrite (ltW z1) ltW.
  apply: closed_bound hy _; exists 1; first exact: ltr01.
  move=> w /andP[w1 w2] _; case: (leP w z) => wz.
    apply: (isd_mono_seg hF) => // v /andP[v1 v2]; rewrite leNgt; apply/negP => Nv.
    move: v2; rewrite le_eqVlt => /orP[/eqP e|vz]; first by move: Nv; rewrite e Nz ltxx.
    by have := T3 v z (lt_le_trans w1 v1) vz z2 (ltW Nv); rewrite Nz ltxx.
  rewrite -ler_opp2; apply: (isd_mono_seg (isd_opp hF)) => //; first exact: ltW.
  move=> v /andP[]; rewrite le_eqVlt oppr_ge0 => /orP[/eqP <- _|v1 v2]; first by rewrite Nz.
  by apply: ltW; apply: T3 v1 _ _ => //; [exact: le_lt_trans w2|rewrite Nz].
case: (eqVneq n 0) => n0.
  by apply: (zero c); rewrite ?c1 //; have [e _ ->] := sg c (introT andP (conj c1 c2)); rewrite n0 horner0 mul0r.
case Er: (roots n (t s) (t s.+1)) => [|z l]; last first.
  have zr : z \in roots n (t s) (t s.+1) by rewrite Er mem_head.
  move: zr; rewrite -roots_on_roots // in_itv /= => /andP[hz rz]; apply: (zero z hz).
  by have [e _ ->] := sg z hz; move: rz; rewrite rootE => /eqP ->; rewrite mul0r.
have nr x : t s < x < t s.+1 -> n.[x] != 0.
  move=> hx; apply/negP => rx; have : x \in roots n (t s) (t s.+1) by rewrite -roots_on_roots // in_itv /= hx.
  by rewrite Er.
have same x y : t s < x -> x < y -> y < t s.+1 -> Num.sg n.[x] = Num.sg n.[y].
  move=> x0 xy y1; have hx := nr x (introT andP (conj x0 (lt_trans xy y1))); have hy := nr y (introT andP (conj (lt_trans x0 xy) y1)).
  apply/eqP/negPn/negP => ne; have [|z] := @ivt_sign R n x y (ltW xy); last first.
    rewrite in_itv /= rootE => /andP[z1 z2]; apply/negP; apply: nr; by rewrite (lt_trans x0 z1) (lt_trans z2).
  move: ne hx hy; case: (sgrP n.[x]) => [//|a|a]; case: (sgrP n.[y]) => [//|b|b]; rewrite ?eqxx // => _ _ _.
    by rewrite mul1r.
  by rewrite mulr1.
have sgc x : t s < x < t s.+1 -> Num.sg n.[x] = Num.sg n.[c].
  move=> /andP[x0 x1]; case: (ltgtP x c) => [h|h|->//]; [exact: same|by symmetry; apply: same].
case: (ltgtP 0 n.[c]) => sc; last by have := nr c; rewrite c1 c2 -sc eqxx => /(_ isT).
  have pos x : t s < x < t s.+1 -> 0 < N' x.
    by move=> hx; have [e e0 ->] := sg x hx; rewrite pmulr_lgt0 // -sgr_gt0 (sgc x hx) sgr_gt0.
  exists (t s.+1) => [|y hy]; first by rewrite lexx ltW.
  apply: closed_bound hy _; exists 1; first exact: ltr01.
  move=> z /andP[z0 z1] _; apply: closed_above; first by rewrite lexx ltW.
  exists (t s.+1 - z); first by rewrite subr_gt0.
  move=> w /andP[w0 w1]; rewrite ltr0_norm ?subr_lt0 // opprB ltr_add2l ltr_opp2 => zw.
  by apply: (isd_mono_seg hF) => //; [exact: ltW|move=> v /andP[v1 v2]; rewrite ltW // pos // (lt_le_trans z0) // (le_lt_trans v2)].
have neg x : t s < x < t s.+1 -> N' x < 0.
  by move=> hx; have [e e0 ->] := sg x hx; rewrite pmulr_llt0 // -sgr_lt0 (sgc x hx) sgr_lt0.
exists (t s) => [|y hy]; first by rewrite lexx ltW.
apply: closed_bound hy _; exists 1; first exact: ltr01.
move=> z /andP[z0 z1] _; apply: closed_above; first by rewrite lexx ltW.
exists (z - t s); first by rewrite subr_gt0.
move=> w /andP[w0 w1]; rewrite gtr0_norm ?subr_gt0 // ltr_add2r => wz.
rewrite -ler_opp2; apply: (isd_mono_seg (isd_opp hF)) => //; [exact: ltW|move=> v /andP[v1 v2]; rewrite oppr_ge0 ltW // neg //].
by rewrite (lt_le_trans w0) // (le_lt_trans v2).
Qed.
End Largest.

(* ---- how a piece depends on its knots: with a common Lipschitz constant ---- *)
Section Uniform.
Variable R : realFieldType.
Variable L : R.
Hypothesis L0 : 0 <= L.
Definition ulip (F : R -> R -> R) := exists2 K, 0 <= K & forall h h' u, 0 <= h <= L -> 0 <= h' <= L -> 0 <= u <= 1 ->
  `|F h u| <= K /\ `|F h u - F h' u| <= K * `|h - h'|.
Lemma ulip_ext (F F' : R -> R -> R) : (forall h u, 0 <= h <= L -> 0 <= u <= 1 -> F h u = F' h u) -> ulip F -> ulip F'.
Proof. by move=> e [K K0 H]; exists K => // h h' u hh hh' hu; rewrite -!e //; apply: H. Qed.
Lemma ulip_const c : ulip (fun _ _ => c).
Proof. by exists `|c| => // h h' u _ _ _; rewrite subrr normr0 lexx mulr_ge0. Qed.
Lemma ulip_h : ulip (fun h _ => h).
Proof.
exists (L + 1); first by rewrite addr_ge0 ?ler01.
move=> h h' u /andP[h0 h1] _ _; split; first by rewrite ger0_norm // (le_trans h1) // ler_addl ler01.
by rewrite ler_pemull // ler_addr.
Qed.
Lemma ulip_u : ulip (fun _ u => u).
Proof. by exists 1; [exact: ler01|move=> h h' u _ _ /andP[u0 u1]; rewrite subrr normr0 mul1r normr_ge0 (ger0_norm u0)]. Qed.
Lemma ulip_add F F' : ulip F -> ulip F' -> ulip (fun h u => F h u + F' h u).
Proof.
move=> [K K0 H] [K' K0' H']; exists (K + K'); first by rewrite addr_ge0.
move=> h h' u hh hh' hu; have [a b] := H h h' u hh hh' hu; have [a' b'] := H' h h' u hh hh' hu.
split; first by rewrite (le_trans (ler_norm_add _ _)) // ler_add.
have -> : F h u + F' h u - (F h' u + F' h' u) = (F h u - F h' u) + (F' h u - F' h' u) by ring.
by rewrite mulrDl (le_trans (ler_norm_add _ _)) // ler_add.
Qed.
Lemma ulip_mul F F' : ulip F -> ulip F' -> ulip (fun h u => F h u * F' h u).
Proof.
move=> [K K0 H] [K' K0' H']; have KK : 0 <= K * K' by rewrite mulr_ge0.
exists (K * K' + K * K'); first by rewrite addr_ge0.
move=> h h' u hh hh' hu; have [a b] := H h h' u hh hh' hu; have [a' b'] := H' h h' u hh hh' hu.
have [c' _] := H' h' h u hh' hh hu.
split; first by rewrite normrM (@le_trans _ _ (K * K')) ?ler_pmul // ler_addl.
have -> : F h u * F' h u - F h' u * F' h' u = F h u * (F' h u - F' h' u) + (F h u - F h' u) * F' h' u by ring.
rewrite mulrDl (le_trans (ler_norm_add _ _)) // !normrM; apply: ler_add.
  by rewrite -mulrA ler_pmul.
by rewrite mulrAC ler_pmul.
Qed.
Lemma ulip_inv F e : 0 < e -> (forall h u, 0 <= h <= L -> 0 <= u <= 1 -> e <= F h u) -> ulip F -> ulip (fun h u => (F h u)^-1).
Proof.
move=> e0 He [K K0 H]; have ei : 0 <= e^-1 by rewrite invr_ge0 ltW.
exists (e^-1 + K * (e^-1 * e^-1)); first by rewrite addr_ge0 // !mulr_ge0.
move=> h h' u hh hh' hu; have [_ b] := H h h' u hh hh' hu.
have p := He h u hh hu; have p' := He h' u hh' hu; have q := lt_le_trans e0 p; have q' := lt_le_trans e0 p'.
have i1 : (F h u)^-1 <= e^-1 by rewrite lef_pinv ?posrE. have i2 : (F h' u)^-1 <= e^-1 by rewrite lef_pinv ?posrE.
split; first by rewrite ger0_norm ?invr_ge0 ?(ltW q) // (le_trans i1) // ler_addl !mulr_ge0.
have -> : (F h u)^-1 - (F h' u)^-1 = - (F h u - F h' u) * ((F h u)^-1 * (F h' u)^-1).
  by field; rewrite !gt_eqF.
rewrite normrM normrN [`|_^-1 * _|]ger0_norm ?mulr_ge0 ?invr_ge0 ?(ltW q) ?(ltW q') //.
apply: (@le_trans _ _ (K * `|h - h'| * (e^-1 * e^-1))).
  by rewrite ler_pmul // ?mulr_ge0 ?invr_ge0 ?(ltW q) ?(ltW q') // ler_pmul // ?invr_ge0 ltW.
by rewrite mulrAC ler_wpmul2r // ler_addr.
Qed.
Lemma ulip_sub F F' : ulip F -> ulip F' -> ulip (fun h u => F h u - F' h u).
Proof.
move=> a b; apply: (ulip_ext _ (ulip_add a (ulip_mul (ulip_const (-1)) b))) => h u _ _; by rewrite mulN1r.
Qed.
Lemma ulip_N (W : nat -> nat -> R -> R -> R) s k i : (forall e j, (j <= s < j + e)%N -> ulip (W e j)) ->
  ulip (fun h u => N (fun e j => W e j h u) s k i).
Proof.
move=> H; elim: k i => [|k IH] i; first exact: ulip_const.
apply: (@ulip_ext (fun h u => W k.+1 i h u * N (fun e j => W e j h u) s k i + (1 - W k.+1 i.+1 h u) * N (fun e j => W e j h u) s k i.+1)) => //.
have zero A j : ~~ (j <= s <= j + k)%N -> ulip (fun h u => A h u * N (fun e j => W e j h u) s k j).
  by move=> h; apply: (ulip_ext _ (ulip_const 0)) => g u _ _; rewrite N_supp // mulr0.
apply: ulip_add.
  case: (boolP (i <= s <= i + k)%N) => e; last exact: zero.
  by apply: ulip_mul => //; apply: H; move: e; clear; lia.
case: (boolP (i.+1 <= s <= i.+1 + k)%N) => e; last exact: (zero (fun h u => 1 - W k.+1 i.+1 h u)).
by apply: ulip_mul => //; apply: ulip_sub; [exact: ulip_const|apply: H; move: e; clear; lia].
Qed.
Variable r : R.
Hypothesis r0 : 0 < r.
Lemma ulip_P (T : R -> nat -> R) (X : R -> R -> R) s k i e : (forall h j, 0 <= h <= L -> T h j <= T h j.+1) ->
  (forall j, ulip (fun h _ => T h j)) -> ulip X -> 0 < e -> (forall h, 0 <= h <= L -> e <= T h s.+1 - T h s) ->
  (forall h u, 0 <= h <= L -> 0 <= u <= 1 -> T h s <= X h u <= T h s.+1) -> ulip (fun h u => P r (T h) s k i (X h u)).
Proof.
move=> mono uT uX e0 He HX; apply: ulip_N => f j /andP[j1 j2].
have um : 0 < Num.min r 1 by rewrite lt_minr r0 ltr01.
have uA : ulip (fun h u => X h u - T h j) by apply: ulip_sub.
have uB : ulip (fun h u => T h (j + f)%N - X h u) by apply: ulip_sub.
have uC : ulip (fun h u => r * (X h u - T h j)) by apply: ulip_mul => //; apply: ulip_const.
apply: (@ulip_ext (fun h u => r * (X h u - T h j) * (r * (X h u - T h j) + (T h (j + f)%N - X h u))^-1)) => //.
apply: ulip_mul => //; apply: (@ulip_inv _ (Num.min r 1 * e)); first by rewrite mulr_gt0.
  move=> h u hh hu; have /andP[x0 x1] := HX h u hh hu; have m := mono h ^~ hh.
  have a : T h j <= T h s by apply: t_le => // l; apply: m.
  have b : T h s.+1 <= T h (j + f)%N by apply: t_le => // l; apply: m.
  apply: (@le_trans _ _ (Num.min r 1 * (X h u - T h j) + Num.min r 1 * (T h (j + f)%N - X h u))).
    rewrite -mulrDr ler_pmul2l //; apply: (le_trans (He h hh)).
    have -> : X h u - T h j + (T h (j + f)%N - X h u) = T h (j + f)%N - T h j by ring.
    by rewrite ler_add // ler_opp2.
  apply: ler_add; first by rewrite ler_wpmul2r ?le_minl ?lexx // subr_ge0 (le_trans a).
  by rewrite -[X in _ <= X]mul1r ler_wpmul2r ?le_minl ?lexx ?orbT // subr_ge0 (le_trans x1).
exact: ulip_add.
Qed.
End Uniform.

(* ---- the pieces as terms of the first-order language ---- *)
Section Terms.
Variable R : rcfType.
Local Notation term := (GRing.term R).
Fixpoint tN (w : nat -> nat -> term) (s k i : nat) : term :=
  if k is d.+1 then GRing.Add (GRing.Mul (w d.+1 i) (tN w s d i)) (GRing.Mul (GRing.Add (GRing.Const 1) (GRing.Opp (w d.+1 i.+1))) (tN w s d i.+1))
  else GRing.Const (i == s)%:R.
Lemma eval_tN e w s k i : GRing.eval e (tN w s k i) = N (fun d j => GRing.eval e (w d j)) s k i.
Proof. by elim: k i => //= k IH i; rewrite !IH. Qed.
Definition tsub (a b : term) := GRing.Add a (GRing.Opp b).
Definition tmob (r : R) (x a b : term) : term := GRing.Mul (GRing.Mul (GRing.Const r) (tsub x a))
  (GRing.Inv (GRing.Add (GRing.Mul (GRing.Const r) (tsub x a)) (tsub b x))).
(* the knots of TwoMaxima.v, moved by the variable 0 *)
Variables (r : R) (d : nat) (p q : R).
Definition tend (a : R) : term := GRing.Add (GRing.Const 1) (GRing.Mul (GRing.Mul (GRing.Const r) (GRing.Add (GRing.Const a) (GRing.Var R 0)))
  (GRing.Inv (tsub (GRing.Const 1) (GRing.Add (GRing.Const a) (GRing.Var R 0))))).
Definition tknot (i : nat) : term :=
  if (i <= d.+1)%N then GRing.Const 0 else if (i <= d.+2)%N then GRing.Const 1 else if (i <= d.+3)%N then tend p else tend q.
Lemma eval_tknot e i : GRing.eval e (tknot i) = knot r d (p + e`_0) (q + e`_0) i.
Proof. by rewrite /tknot /knot; case: ifP => // _; case: ifP => // _; case: ifP. Qed.
Definition tP s k i (x : term) : term := tN (fun e j => tmob r x (tknot j) (tknot (j + e)%N)) s k i.
Lemma eval_tP e s k i x : GRing.eval e (tP s k i x) = P r (knot r d (p + e`_0) (q + e`_0)) s k i (GRing.eval e x).
Proof.
rewrite /tP eval_tN /P /piece; apply: N_ext => f j _ _.
by rewrite /= !eval_tknot.
Qed.
End Terms.

Section Slope.
Variable R : realFieldType.
(* where the derivative is positive, values right of x are greater and values left of it less *)
Lemma taylor_rise (f : R -> R) x v l : taylor f x v l -> 0 < l -> exists2 e, 0 < e & forall z, 0 < z < e -> v < f (x + z) /\ f (x - z) < v.
Proof.
move=> tf l0; have t1 := taylor_add (taylor_shift 1 tf) (taylor_const (- v) 0).
have t2 := taylor_scale (-1) (taylor_add (taylor_shift (-1) tf) (taylor_const (- v) 0)).
rewrite subrr mul1r addr0 in t1; rewrite subrr mulr0 addr0 !mulN1r opprK in t2.
have [e e0 H] := taylor_pos t1 (or_intror (conj erefl l0)); have [e' e0' H'] := taylor_pos t2 (or_intror (conj erefl l0)).
exists (Num.min e e'); first by rewrite lt_minr e0.
move=> z /andP[z0]; rewrite lt_minr => /andP[z1 z2]; split.
  by have := H z ltac:(by rewrite z0); rewrite mul1r subr_gt0.
by have := H' z ltac:(by rewrite z0); rewrite !mulN1r oppr_gt0 subr_lt0.
Qed.
Lemma taylor_fall (f : R -> R) x v l : taylor f x v l -> l < 0 -> exists2 e, 0 < e & forall z, 0 < z < e -> f (x + z) < v /\ v < f (x - z).
Proof.
move=> tf l0; have := taylor_rise (taylor_scale (-1) tf) (l := -1 * l) ltac:(by rewrite mulN1r oppr_gt0).
by move=> [e e0 H]; exists e => // z /H; rewrite !mulN1r !ltr_opp2 => -[].
Qed.
End Slope.

Section Tie.
Variable R : rcfType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable d : nat.
Variables p q L : R.
Hypothesis p0 : 0 < p.
Hypothesis pq : p < q.
Hypothesis L0 : 0 < L.
Hypothesis q1 : q + L < 1.
Local Notation s := d.+1.
Local Notation k := d.+3.
Local Notation T h := (knot r d (p + h) (q + h)).
Local Notation inL h := (0 <= h <= L).
Definition Fl h u := P r (T h) s k 0 u.
Definition step_ h := r * (p + h) / (1 - (p + h)).
Definition Fr h u := P r (T h) s.+1 k 0 (1 + u * step_ h).
Section At.
Variable h : R.
Hypothesis hL : inL h.
Let ph : 0 < p + h. Proof. by case/andP: hL => h0 _; rewrite ltr_paddr. Qed.
Let pqh : p + h < q + h. Proof. by rewrite ltr_add2r. Qed.
Let qh : q + h < 1. Proof. by case/andP: hL => _ h1; apply: le_lt_trans q1; rewrite ler_add2l. Qed.
Lemma T_mono j : T h j <= T h j.+1. Proof. exact: knot_mono. Qed.
Lemma Ts j : (j <= s)%N -> T h j = 0. Proof. exact: kn0. Qed.
Lemma T1 : T h s.+1 = 1. Proof. exact: kn1. Qed.
Lemma T2 : T h s.+2 = 1 + step_ h. Proof. by rewrite kn2. Qed.
Lemma step_gt0 : 0 < step_ h.
Proof. by rewrite divr_gt0 ?mulr_gt0 // subr_gt0 (lt_trans pqh). Qed.
Lemma T3 : T h s.+2 < T h s.+3.
Proof. by rewrite kn2 kn3 // ltr_add2l; apply: e_lt. Qed.
Lemma T4 j : (s.+2 < j)%N -> T h j = T h s.+3.
Proof. by move=> hj; rewrite !kn3. Qed.
Lemma T0m : T h 0 < T h k.+1.
Proof. by rewrite Ts // (lt_trans ltr01) // (lt_trans _ T3) // T2 ltr_addl step_gt0. Qed.
Lemma mult1 y : T h 0 < y < T h k.+1 -> (mult (T h) k.+1 y <= k)%N.
Proof. by move=> hy; apply: (@inside_mult R (T h) T_mono 0 k 0). Qed.
Lemma left_value j y : (j < k.+1)%N -> T h j < y -> y <= T h j.+1 -> y < T h k.+1 -> G (wt r (T h)) (T h) k 0 y = P r (T h) j k 0 y.
Proof.
move=> jk y0 y1 ym; have hy : T h 0 < y < T h k.+1 by rewrite ym andbT (le_lt_trans _ y0) // (t_le T_mono).
have [a [a1 a2 am E]] := P3_1_2_paper r_gt0 T_mono 0 hy (mult1 hy).
by rewrite E -(left_span_uniq T_mono am (x := y)) ?a1 // (left_span_uniq T_mono (s := j)) ?y0.
Qed.
Lemma right_value j y : T h j <= y -> y < T h j.+1 -> G (wt r (T h)) (T h) k 0 y = P r (T h) j k 0 y.
Proof. by move=> y0 y1; apply: G_P; [exact: T_mono|rewrite y0]. Qed.
Lemma T2m : T h s.+2 < T h k.+1. Proof. exact: T3. Qed.
Lemma T12 : T h s.+1 < T h s.+2. Proof. by rewrite T1 T2 ltr_addl step_gt0. Qed.
Let k1 : (s < k.+1)%N. Proof. by clear; lia. Qed.
Let k2 : (s.+1 < k.+1)%N. Proof. by clear; lia. Qed.
Lemma F1 : Fl h 1 = Fr h 0.
Proof.
rewrite /Fl /Fr mul0r addr0 -(@left_value s 1) ?T1 ?(Ts (leqnn _)) ?ltr01 //; last by rewrite -[X in X < _]T1 (lt_trans T12) // T2m.
by rewrite (@right_value s.+1 1) ?T1 // -[X in X < _]T1 T12.
Qed.
Lemma slopes : r^-1 * SS (p + h) (q + h) d + E r^-1 (p + h) (q + h) s = dP r (T h) s k 0 1 /\
  SS (p + h) (q + h) d + E r^-1 (p + h) (q + h) s = dP r (T h) s.+1 k 0 1.
Proof. by rewrite two_left // two_right. Qed.
Lemma taylor_l : taylor (P r (T h) s k 0) 1 (Fl h 1) (dP r (T h) s k 0 1).
Proof. by apply: P_taylor => //; [exact: T_mono|by rewrite Ts // T1 ltr01|by rewrite Ts // T1 ler01 lexx]. Qed.
Lemma taylor_r : taylor (P r (T h) s.+1 k 0) 1 (Fl h 1) (dP r (T h) s.+1 k 0 1).
Proof.
have -> : Fl h 1 = P r (T h) s.+1 k 0 1 by rewrite F1 /Fr mul0r addr0.
by apply: P_taylor => //; [exact: T_mono|exact: T12|by rewrite T1 lexx -[X in X <= _]T1 ltW ?T12].
Qed.
Let uni a x y z : (0 <= a <= 0 + k)%N -> T h a < x -> x < y -> y < z -> z < T h a.+1 ->
  Num.min (G (wt r (T h)) (T h) k 0 x) (G (wt r (T h)) (T h) k 0 z) < G (wt r (T h)) (T h) k 0 y.
Proof. by move=> ha; apply: (paper_unimodal r_gt0 T_mono _ ha). Qed.
Lemma low_l x b y : 0 <= x -> x < b -> b < y -> y <= 1 -> Num.min (Fl h x) (Fl h y) <= Fl h b.
Proof.
move=> x0 xb bY y1; by apply: (closed_low r_gt0 T_mono uni) ; rewrite ?(Ts (leqnn _)) ?T1.
Qed.
Lemma low_r x b y : 1 <= x -> x < b -> b < y -> y <= 1 + step_ h ->
  Num.min (P r (T h) s.+1 k 0 x) (P r (T h) s.+1 k 0 y) <= P r (T h) s.+1 k 0 b.
Proof.
move=> x0 xb bY y1; by apply: (closed_low r_gt0 T_mono uni) ; rewrite ?T1 ?T2.
Qed.
(* D+ negative: nothing after 1 is larger *)
Lemma after_1 : dP r (T h) s.+1 k 0 1 < 0 -> forall u, 0 <= u <= 1 -> Fr h u <= Fl h 1.
Proof.
move=> neg u /andP[u0 u1]; rewrite leNgt; apply/negP => c.
have x1 : 1 < 1 + u * step_ h.
  rewrite ltr_addl mulr_gt0 ?step_gt0 // lt_neqAle u0 andbT; apply/negP => /eqP e.
  by move: c; rewrite F1 -e ltxx.
have x2 : 1 + u * step_ h <= 1 + step_ h by rewrite ler_add2l -[X in _ <= X]mul1r ler_pmul2r // step_gt0.
have [e e0 H] := taylor_fall taylor_r neg.
have [z [z0 z1 z2]] := small2 e0 (b := u * step_ h) ltac:(by move: x1; rewrite ltr_addl).
have [Hz _] := H z ltac:(by rewrite z0).
have := @low_r 1 (1 + z) (1 + u * step_ h) (lexx _) ltac:(by rewrite ltr_addl) ltac:(by rewrite ltr_add2l) x2.
have e1 : P r (T h) s.+1 k 0 1 = Fl h 1 by rewrite F1 /Fr mul0r addr0.
by rewrite e1 le_minl leNgt Hz /= leNgt (lt_trans Hz).
Qed.
(* D- positive: nothing before 1 is larger *)
Lemma before_1 : 0 < dP r (T h) s k 0 1 -> forall u, 0 <= u <= 1 -> Fl h u <= Fl h 1.
Proof.
move=> pos u /andP[u0 u1]; rewrite leNgt; apply/negP => c.
have x1 : u < 1 by rewrite lt_neqAle u1 andbT; apply/negP => /eqP e; move: c; rewrite e ltxx.
have [e e0 H] := taylor_rise taylor_l pos.
have [z [z0 z1 z2]] := small2 e0 (b := 1 - u) ltac:(by rewrite subr_gt0).
have [_ Hz] := H z ltac:(by rewrite z0).
have := @low_l u (1 - z) 1 u0 ltac:(by rewrite ltr_subr_addr addrC -ltr_subr_addr) ltac:(by rewrite ltr_subl_addr ltr_addl) (lexx _).
by rewrite le_minl leNgt (lt_trans Hz c) /= leNgt Hz.
Qed.
Lemma max_l : exists2 x, 0 <= x <= 1 & forall u, 0 <= u <= 1 -> Fl h u <= Fl h x.
Proof.
have [||x hx H] := @span_max R r r_gt0 (T h) T_mono k 0 s isT.
- by rewrite add0n; clear; lia.
- by rewrite Ts // T1 ltr01.
by exists x; move: hx H; rewrite Ts // T1.
Qed.
Lemma max_r : exists2 x, 0 <= x <= 1 & forall u, 0 <= u <= 1 -> Fr h u <= Fr h x.
Proof.
have s0 := step_gt0; have [||x hx H] := @span_max R r r_gt0 (T h) T_mono k 0 s.+1 isT.
- by rewrite add0n; clear; lia.
- exact: T12.
move: hx H; rewrite T1 T2 => /andP[x0 x1] H; exists ((x - 1) / step_ h).
  by rewrite divr_ge0 ?subr_ge0 ?(ltW s0) //= ler_pdivr_mulr // mul1r ler_subl_addl.
move=> u /andP[u0 u1]; rewrite /Fr divfK ?gt_eqF // [1 + (x - 1)]addrC subrK; apply: H.
by rewrite ler_addl mulr_ge0 ?(ltW s0) //= ler_add2l -[X in _ <= X]mul1r ler_pmul2r.
Qed.
(* no value is larger than those on the two spans around 1 *)
Lemma all_values M x : 0 <= M -> (forall u, 0 <= u <= 1 -> Fl h u <= M) -> (forall u, 0 <= u <= 1 -> Fr h u <= M) -> value r (T h) (0 + k.+1) k 0 x <= M.
Proof.
move=> M0 Ml Mr; have U := T0m; have s0 := step_gt0; case: (ltP x (T h (0 + k.+1)%N)) => xm; last first.
  move: xm; rewrite le_eqVlt => /orP[/eqP <-|xm]; last by rewrite value_out.
  rewrite (value_tmE r_gt0 T_mono) //.
  have [a1 a2 a3] := last_spanP T_mono U; case: eqP => // e; move: a3; rewrite -e Ts // => /eqP.
  by rewrite lt_eqF // -(Ts (leq0n _)).
rewrite value_in //; case: (ltP x 0) => x0.
  have -> : G (wt r (T h)) (T h) k 0 x = 0; last by [].
  by apply: T3_5_1_outside; [exact: T_mono|rewrite negb_and -ltNge Ts // x0].
case: (ltP x 1) => x1; first by rewrite (@right_value s x) ?(Ts (leqnn _)) ?T1 //; apply: Ml; rewrite x0 ltW.
case: (leP x (1 + step_ h)) => x2.
  have -> : G (wt r (T h)) (T h) k 0 x = P r (T h) s.+1 k 0 x.
    case: (ltgtP x 1) x1 => // [x1 _|-> _]; last by rewrite (@right_value s.+1 1) ?T1 // -[X in X < _]T1 T12.
    by rewrite (@left_value s.+1 x) ?T1 ?T2.
  have := Mr ((x - 1) / step_ h); rewrite /Fr divfK ?gt_eqF // [1 + (x - 1)]addrC subrK; apply.
  by rewrite divr_ge0 ?subr_ge0 ?(ltW s0) //= ler_pdivr_mulr // mul1r ler_subl_addl.
have e2 : T h (0 + k)%N = 1 + step_ h by rewrite add0n T2.
have [g _] := @last_falls R r r_gt0 (T h) T_mono k 0 (1 + step_ h) x ltac:(by rewrite e2) x2 xm.
apply: (le_trans g); rewrite (@left_value s.+1) ?T1 ?T2 ?ltr_addl //; last by rewrite -T2 T2m.
by have := Mr 1; rewrite /Fr mul1r ler01 lexx; apply.
Qed.
End At.
(* both pieces, with one constant for all knots of the segment *)
Lemma uniform : exists2 K, 0 < K & forall h h' u, inL h -> inL h' -> 0 <= u <= 1 ->
  `|Fl h u - Fl h' u| <= K * `|h - h'| /\ `|Fr h u - Fr h' u| <= K * `|h - h'|.
Proof.
have L0' := ltW L0; have uh := @ulip_h R L L0'; have uc := @ulip_const R L.
have e0 : 0 < 1 - (q + L) by rewrite subr_gt0.
have uend a : a <= q -> ulip L (fun h _ => r * (a + h) / (1 - (a + h))).
  move=> aq; apply: ulip_mul; first by apply: ulip_mul; [exact: uc|apply: ulip_add; [exact: uc|exact: uh]].
  apply: (ulip_inv e0) => [h u /andP[h0 h1] _|]; first by rewrite ler_add2l ler_opp2 ler_add.
  by apply: ulip_sub; [exact: uc|apply: ulip_add; [exact: uc|exact: uh]].
have uT j : ulip L (fun h _ => T h j).
  rewrite /knot; case: (j <= s)%N; first exact: uc.
  case: (j <= s.+1)%N; first exact: uc.
  by case: (j <= s.+2)%N; (apply: ulip_add; first exact: uc); apply: uend => //; exact: ltW.
have us : ulip L (fun h _ => step_ h) by apply: uend; exact: ltW.
have [K K0 HK] : ulip L Fl.
  rewrite /Fl; apply: (@ulip_P R L r r_gt0 (fun h => T h) (fun _ u => u) s k 0 1) => //.
  - by move=> h j hh; apply: T_mono.
  - exact: ulip_u.
  - by move=> h hh; rewrite T1 Ts // subr0.
  - by move=> h u hh; rewrite T1 Ts.
have [K' K0' HK'] : ulip L Fr.
  have rp : 0 < r * p by rewrite mulr_gt0.
  rewrite /Fr; apply: (@ulip_P R L r r_gt0 (fun h => T h) (fun h u => 1 + u * step_ h) s.+1 k 0 (r * p)) => //.
  - by move=> h j hh; apply: T_mono.
  - by apply: ulip_add; [exact: uc|apply: ulip_mul => //; exact: ulip_u].
  - move=> h hh; have /andP[h0 h1] := hh; rewrite T1 T2 addrAC subrr add0r /step_.
    have ph : p + h < 1 by apply: le_lt_trans q1; rewrite ler_add // ltW.
    rewrite ler_pdivl_mulr ?subr_gt0 // -mulrA ler_pmul2l //.
    apply: (@le_trans _ _ p); last by rewrite ler_addl.
    by rewrite -[X in _ <= X]mulr1 ler_pmul2l // ler_subl_addr ler_addl addr_ge0 // ltW.
  - move=> h u hh /andP[u0 u1]; have s0 := step_gt0 hh; rewrite T1 T2 ler_addl mulr_ge0 ?(ltW s0) //=.
    by rewrite ler_add2l -[X in _ <= X]mul1r ler_pmul2r.
exists (K + K' + 1); first by rewrite ltr_paddl ?ltr01 // addr_ge0.
move=> h h' u hh hh' hu; have [_ a] := HK h h' u hh hh' hu; have [_ b] := HK' h h' u hh hh' hu.
split; [apply: (le_trans a)|apply: (le_trans b)]; rewrite ler_wpmul2r // -addrA.
  by rewrite ler_addl addr_ge0 ?ler01.
by rewrite addrCA ler_addl addr_ge0 ?ler01.
Qed.
Hypothesis Dp : SS p q d + E r^-1 p q s < 0.
Hypothesis Dm : 0 < r^-1 * SS (p + L) (q + L) d + E r^-1 (p + L) (q + L) s.
Hypothesis jump : forall h, 0 <= h -> h <= L -> 0 < (1 - r^-1) * SS (p + h) (q + h) d.
Lemma slopes_lt h : inL h -> dP r (T h) s k 0 1 < dP r (T h) s.+1 k 0 1.
Proof.
move=> hh; have /andP[h0 h1] := hh; have [<- <-] := slopes hh.
by rewrite ltr_add2r -subr_gt0 -{1}[SS _ _ _]mul1r -mulrBl jump.
Qed.
Definition higher h := exists y, (0 <= y /\ y <= 1) /\ forall u, (0 <= u /\ u <= 1) -> Fr h u <= Fl h y.
Lemma higher0 : higher 0.
Proof.
have h0 : 0 <= (0 : R) <= L by apply/andP; split; [exact: lexx|exact: ltW].
exists 1; split; first by split; [exact: ler01|exact: lexx].
move=> u [u0 u1]; apply: (after_1 h0); last by rewrite u0.
by have [_ <-] := slopes h0; rewrite !addr0.
Qed.
Lemma higherL : ~ higher L.
Proof.
have hL : 0 <= L <= L by apply/andP; split; [exact: ltW|exact: lexx].
move=> [y [[y0 y1] H]]; have [e1 e2] := slopes hL; have lt := slopes_lt hL.
have pos : 0 < dP r (T L) s k 0 1 by rewrite -e1.
have le := before_1 hL pos (introT andP (conj y0 y1)).
have [e e0 He] := taylor_rise (taylor_r hL) (lt_trans pos lt).
have s0 := step_gt0 hL; have [z [z0 z1 z2]] := small2 e0 s0; have [Hz _] := He z ltac:(by rewrite z0).
have hz : 0 <= z / step_ L /\ z / step_ L <= 1.
  by rewrite divr_ge0 ?(ltW z0) ?(ltW s0) // ler_pdivr_mulr // mul1r ltW.
by have := H _ hz; rewrite /Fr divfK ?gt_eqF // leNgt (le_lt_trans le Hz).
Qed.
Lemma tie : exists h x1 x2, [/\ inL h, 0 <= x1 < 1, 0 < x2 <= 1 & [/\ Fl h x1 = Fr h x2, 0 <= Fl h x1,
  forall u, 0 <= u <= 1 -> Fl h u <= Fl h x1 & forall u, 0 <= u <= 1 -> Fr h u <= Fl h x1]].
Proof.
pose X0 := GRing.Var R 0; pose X1 := GRing.Var R 1; pose X2 := GRing.Var R 2.
pose C := @GRing.Const R.
pose between x := ord.And (ord.Le (C 0) x) (ord.Le x (C 1)).
pose tstep := GRing.Mul (GRing.Mul (C r) (GRing.Add (C p) X0)) (GRing.Inv (tsub (C 1) (GRing.Add (C p) X0))).
pose tr := tP r d p q s.+1 k 0 (GRing.Add (C 1) (GRing.Mul X2 tstep)); pose tl := tP r d p q s k 0 X1.
pose f := ord.Exists 1 (ord.And (between X1) (ord.Forall 2 (ord.Implies (between X2) (ord.Le tr tl)))).
have hf h : higher h <-> ord.holds [:: h] f.
  have E y u : GRing.eval [:: h; y; u] tr = Fr h u /\ GRing.eval [:: h; y; u] tl = Fl h y by rewrite !eval_tP.
  split=> [[y [hy H]]|[y [hy H]]]; exists y; split=> // u hu; have [e1 e2] := E y u.
    by have := H u hu; rewrite -e1 -e2.
  by rewrite -e1 -e2; exact: (H u hu).
have [c [hc near]] := definable_boundary hf L0 higher0 higherL.
have [K K0 HK] := uniform; have [xl hl Ml] := max_l hc; have [xr hr Mr] := max_r hc.
have two : 0 < 2%:R :> R by rewrite ltr0n.
have eqM : Fl c xl = Fr c xr.
  case: (ltgtP (Fl c xl) (Fr c xr)) => // lt.
    have e0 : 0 < (Fr c xr - Fl c xl) / (2%:R * K) by rewrite divr_gt0 ?mulr_gt0 // subr_gt0.
    have [x [y [hx hy xe ye [[z [[z0 z1] H]] _]]]] := near _ e0.
    have hz : 0 <= z <= 1 by rewrite z0.
    have [_ a] := HK x c xr hx hc hr; have [b _] := HK x c z hx hc hz.
    have k1 : K * `|x - c| < (Fr c xr - Fl c xl) / 2%:R.
      by move: xe; rewrite invfM mulrA ltr_pdivl_mulr // mulrC.
    have l1 := H xr (elimT andP hr); have l2 := Ml z hz.
    move: a b; rewrite !ler_norml => /andP[a _] /andP[_ b].
    have : Fr c xr - Fl c xl <= K * `|x - c| + K * `|x - c|.
      have -> : Fr c xr - Fl c xl = (Fr c xr - Fr x xr) + (Fr x xr - Fl x z) + (Fl x z - Fl c z) + (Fl c z - Fl c xl) by ring.
      rewrite -[X in _ <= X]addr0 ler_add ?subr_le0 //; apply: ler_add => //.
      by rewrite -[X in _ <= X]addr0 ler_add ?subr_le0 // -[X in X <= _]opprB ler_oppl.
    rewrite leNgt; case/negP; have -> : Fr c xr - Fl c xl = (Fr c xr - Fl c xl) / 2%:R + (Fr c xr - Fl c xl) / 2%:R by field.
    exact: ltr_add.
  have e0 : 0 < (Fl c xl - Fr c xr) / (2%:R * K) by rewrite divr_gt0 ?mulr_gt0 // subr_gt0.
  have [x [y [hx hy xe ye [_ nh]]]] := near _ e0; case: nh; exists xl; split; first by case/andP: hl.
  move=> u [u0 u1]; have hu : 0 <= u <= 1 by rewrite u0.
  have [_ a] := HK y c u hy hc hu; have [b _] := HK y c xl hy hc hl.
  have k1 : K * `|y - c| < (Fl c xl - Fr c xr) / 2%:R.
    by move: ye; rewrite invfM mulrA ltr_pdivl_mulr // mulrC.
  have l2 := Mr u hu; move: a b; rewrite !ler_norml => /andP[_ a] /andP[b _].
  rewrite -subr_ge0; apply: (@le_trans _ _ ((Fl c xl - Fr c xr) - (K * `|y - c| + K * `|y - c|))).
    rewrite subr_ge0; have -> : Fl c xl - Fr c xr = (Fl c xl - Fr c xr) / 2%:R + (Fl c xl - Fr c xr) / 2%:R by field.
    by rewrite ltW // ltr_add.
  have -> : Fl y xl - Fr y u = (Fl c xl - Fr c u) - ((Fr y u - Fr c u) + (Fl c xl - Fl y xl)) by ring.
  apply: ler_add; first by rewrite ler_add2l ler_opp2.
  by rewrite ler_opp2 ler_add // -[X in X <= _]opprB ler_oppl.
have i1 : 0 <= (1 : R) <= 1 by apply/andP; split; [exact: ler01|exact: lexx].
have gt1 : Fl c 1 < Fl c xl.
  rewrite lt_neqAle Ml // andbT; apply/negP => /eqP e.
  have dm : 0 <= dP r (T c) s k 0 1.
    rewrite leNgt; apply/negP => neg; have [z1 z10 Hz] := taylor_fall (taylor_l hc) neg.
    have [z [z0 zz1 z2]] := small2 z10 ltr01; have [_] := Hz z ltac:(by rewrite z0); rewrite e ltNge; case/negP.
    by apply: (Ml (1 - z)); rewrite subr_ge0 (ltW z2) ler_subl_addr ler_addl ltW.
  have dp : dP r (T c) s.+1 k 0 1 <= 0.
    rewrite leNgt; apply/negP => pos; have [z1 z10 Hz] := taylor_rise (taylor_r hc) pos; have s0 := step_gt0 hc.
    have [z [z0 zz1 z2]] := small2 z10 s0; have [lt _] := Hz z ltac:(by rewrite z0); rewrite e eqM in lt.
    have hz : 0 <= z / step_ c <= 1.
      by rewrite divr_ge0 ?(ltW z0) ?(ltW s0) //= ler_pdivr_mulr // mul1r ltW.
    by have := Mr _ hz; rewrite {1}/Fr divfK ?gt_eqF // leNgt lt.
  by have := slopes_lt hc; rewrite ltNge (le_trans dp dm).
have Mp : 0 <= Fl c xl.
  have /andP[x0 x1] := hl; rewrite /Fl; apply: N_ge0 => e j; apply: (@span_01 R (T c) (T_mono hc) s) => //.
    by rewrite Ts // T1 ltr01.
  by rewrite Ts // T1.
exists c, xl, xr; have /andP[l0 l1] := hl; have /andP[r0 r1] := hr; split=> //.
- by rewrite l0 lt_neqAle l1 andbT; apply/negP => /eqP e; move: gt1; rewrite e ltxx.
- rewrite r1 andbT lt_neqAle r0 andbT; apply/negP => /eqP e; move: gt1; rewrite eqM -e -(F1 hc) ltxx //.
by split=> // u hu; rewrite eqM; apply: Mr.
Qed.
End Tie.

(* Conj3.1.weak.continuous is false for every k >= 3 and every r <> 1: knots t_0 <= .. <= t_(k+1) with multiplicities at most k inside, and
   two points of the support at which G_0^k takes its largest value; real closed fields, as these points are roots of polynomials *)
Theorem Conj3_1_weak_continuous_printed_false (R : rcfType) (r : R) k : 0 < r -> r != 1 -> (3 <= k)%N ->
  exists (t : nat -> R) (x1 x2 : R), let f := value r t k.+1 k 0 in
  [/\ forall i, t i <= t i.+1, t 0%N < t k.+1, forall y, t 0%N < y < t k.+1 -> (mult t k.+1 y <= k)%N &
   [/\ t 0%N <= x1, x1 < x2, x2 <= t k.+1, f x1 = f x2 & forall x, f x <= f x1]].
Proof.
case: k => [|[|[|d]]] // r0 r1 _.
have ri0 : 0 < r^-1 by rewrite invr_gt0. have ri1 : r^-1 != 1 by rewrite invr_eq1.
have [p [q [L [p0 pq L0 q1 [Dp Dm jump]]]]] := segment d ri0 ri1.
have [h [x1 [x2 [hh /andP[x10 x11] /andP[x20 x21] [eM M0 Ml Mr]]]]] := tie r0 p0 pq L0 q1 Dp Dm jump.
have s0 := step_gt0 r0 p0 pq q1 hh.
pose t := knot r d (p + h) (q + h); exists t, x1, (1 + x2 * step_ r p h).
have tm i : t i <= t i.+1 by exact: (T_mono r0 d p0 pq q1 hh).
have t0 i : (i <= d.+1)%N -> t i = 0 by exact: kn0.
have t1 : t d.+2 = 1 by exact: kn1.
have t2 : t d.+3 = 1 + step_ r p h by rewrite /t kn2.
have t3 : t d.+3 < t d.+4 by exact: (T3 r0 d pq q1 hh).
have U : t 0%N < t d.+4 by exact: (T0m r0 d p0 pq q1 hh).
have y2 : 1 + x2 * step_ r p h <= 1 + step_ r p h by rewrite ler_add2l -[X in _ <= X]mul1r ler_pmul2r.
have y1 : 1 < 1 + x2 * step_ r p h by rewrite ltr_addl mulr_gt0.
have m4 : 1 + x2 * step_ r p h < t d.+4 by apply: le_lt_trans t3; rewrite t2.
have v1 : value r t d.+4 d.+3 0 x1 = Fl r d p q h x1.
  rewrite value_in; last by apply: (lt_trans x11); apply: (lt_trans y1).
  by apply: (@right_value R r r0 d p q L p0 pq q1 h hh d.+1); rewrite -/t ?(t0 _ (leqnn _)) ?t1.
have v2 : value r t d.+4 d.+3 0 (1 + x2 * step_ r p h) = Fr r d p q h x2.
  rewrite value_in //; apply: (@left_value R r r0 d p q L p0 pq q1 h hh d.+2) => //; rewrite -/t ?t1 ?t2 //.
move=> f; split; [exact: tm|exact: U|exact: (@mult1 R r r0 d p q L p0 pq q1 h hh)|].
split; [by rewrite t0|exact: lt_trans x11 y1|exact: ltW m4|by rewrite /f v1 v2|].
by move=> x; rewrite /f v1; exact: (@all_values R r r0 d p q L p0 pq q1 h hh).
Qed.
