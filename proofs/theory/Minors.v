(* Neighbouring functions: G_(i+1)/G_i does not fall, so that every minor of two rows and two columns of (G_i(x_j)) is non-negative,
   for every degree, every r and all knots with inner multiplicities at most k. The proof compares two points of a span, without
   derivatives; f << g means that g/f does not fall from x to y. In the limit it is about the derivatives at one point. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis StatementsCurves Cumulative TwoMaxima Terms.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Relation.
Variable R : realFieldType.
(* f at x, f' at y *)
Definition lr (f f' g g' : R) := f' * g <= f * g'.
Lemma lr_trans (g g' f f' h h' : R) : 0 < g -> 0 < g' -> 0 <= f -> 0 <= f' -> 0 <= h -> 0 <= h' -> lr f f' g g' -> lr g g' h h' -> lr f f' h h'.
Proof.
rewrite /lr => g0 g0' f0 f0' h0 h0' h1 h2; rewrite -(ler_pmul2r (mulr_gt0 g0 g0')).
have -> : f' * h * (g * g') = (f' * g) * (g' * h) by ring.
have -> : f * h' * (g * g') = (f * g') * (g * h') by ring.
by rewrite ler_pmul // mulr_ge0 // ltW.
Qed.
Lemma lr_add2 (f1 f1' f2 f2' g1 g1' g2 g2' : R) : lr f1 f1' g1 g1' -> lr f1 f1' g2 g2' -> lr f2 f2' g1 g1' -> lr f2 f2' g2 g2' ->
  lr (f1 + f2) (f1' + f2') (g1 + g2) (g1' + g2').
Proof.
rewrite /lr => a b c d.
have -> : (f1' + f2') * (g1 + g2) = (f1' * g1 + f1' * g2) + (f2' * g1 + f2' * g2) by ring.
have -> : (f1 + f2) * (g1' + g2') = (f1 * g1' + f1 * g2') + (f2 * g1' + f2 * g2') by ring.
by apply: ler_add; apply: ler_add.
Qed.
Lemma lr_scale (u u' f f' g g' : R) : 0 <= u -> 0 <= u' -> lr f f' g g' -> lr (u * f) (u' * f') (u * g) (u' * g').
Proof.
rewrite /lr => u0 u0' h.
have -> : u' * f' * (u * g) = u * u' * (f' * g) by ring.
have -> : u * f * (u' * g') = u * u' * (f * g') by ring.
by rewrite ler_wpmul2l // mulr_ge0.
Qed.
End Relation.

Section TwoPoints.
Variable R : realFieldType.
Variables (w w' : nat -> nat -> R) (s : nat).
Local Notation inside d i := (i <= s < i + d)%N.
Hypothesis h : forall e j, inside e j -> 0 < w e j < 1.
Hypothesis h' : forall e j, inside e j -> 0 < w' e j < 1.
Hypothesis le : forall e j, inside e j -> w e j <= w' e j.
Hypothesis step : forall d i, (i < s < i + d.+2)%N ->
  lr (w d.+2 i * (1 - w d.+1 i.+1)) (w' d.+2 i * (1 - w' d.+1 i.+1)) ((1 - w d.+2 i.+1) * w d.+1 i.+1) ((1 - w' d.+2 i.+1) * w' d.+1 i.+1).
Local Notation F d i := (w d.+1 i * N w s d i).
Local Notation F' d i := (w' d.+1 i * N w' s d i).
Local Notation H d i := ((1 - w d.+1 i) * N w s d i).
Local Notation H' d i := ((1 - w' d.+1 i) * N w' s d i).
Lemma zero_lr (f f' : R) : lr 0 0 f f'.
Proof. by rewrite /lr !mul0r. Qed.
Lemma lr_zero (f f' : R) : lr f f' 0 0.
Proof. by rewrite /lr !mulr0. Qed.
Let n0 d i : (i <= s <= i + d)%N -> 0 < N w s d i := N_gt0 h.
Let n0' d i : (i <= s <= i + d)%N -> 0 < N w' s d i := N_gt0 h'.
Lemma strong d i : (s <= i + d)%N -> (i < s)%N -> lr (F d i) (F' d i) (H d i.+1) (H' d i.+1).
Proof.
elim: d i => [|d IH] i hi lt; first by move: hi lt; clear; lia.
have /andP[W0 W1] := h (e := d.+2) (j := i) ltac:(move: hi lt; clear; lia).
have /andP[W0' W1'] := h' (e := d.+2) (j := i) ltac:(move: hi lt; clear; lia).
have /andP[Z0 Z1] := h (e := d.+2) (j := i.+1) ltac:(move: hi lt; clear; lia).
have /andP[Z0' Z1'] := h' (e := d.+2) (j := i.+1) ltac:(move: hi lt; clear; lia).
have /andP[v0 v1] := h (e := d.+1) (j := i.+1) ltac:(move: hi lt; clear; lia).
have /andP[v0' v1'] := h' (e := d.+1) (j := i.+1) ltac:(move: hi lt; clear; lia).
have m0 := n0 (d := d) (i := i.+1) ltac:(move: hi lt; clear; lia).
have m0' := n0' (d := d) (i := i.+1) ltac:(move: hi lt; clear; lia).
have Zp : 0 < 1 - w d.+2 i.+1 by rewrite subr_gt0. have Zp' : 0 < 1 - w' d.+2 i.+1 by rewrite subr_gt0.
have vp : 0 < 1 - w d.+1 i.+1 by rewrite subr_gt0. have vp' : 0 < 1 - w' d.+1 i.+1 by rewrite subr_gt0.
have a : lr (w d.+2 i * H d i.+1) (w' d.+2 i * H' d i.+1) ((1 - w d.+2 i.+1) * F d i.+1) ((1 - w' d.+2 i.+1) * F' d i.+1).
  have := @step d i ltac:(move: hi lt; clear; lia); rewrite /lr => q.
  have -> : w' d.+2 i * H' d i.+1 * ((1 - w d.+2 i.+1) * F d i.+1) =
    N w s d i.+1 * N w' s d i.+1 * (w' d.+2 i * (1 - w' d.+1 i.+1) * ((1 - w d.+2 i.+1) * w d.+1 i.+1)) by ring.
  have -> : w d.+2 i * H d i.+1 * ((1 - w' d.+2 i.+1) * F' d i.+1) =
    N w s d i.+1 * N w' s d i.+1 * (w d.+2 i * (1 - w d.+1 i.+1) * ((1 - w' d.+2 i.+1) * w' d.+1 i.+1)) by ring.
  by rewrite ler_wpmul2l // mulr_ge0 // ltW.
have g0 : 0 < w d.+2 i * H d i.+1 by rewrite !mulr_gt0. have g0' : 0 < w' d.+2 i * H' d i.+1 by rewrite !mulr_gt0.
have f0 : 0 < (1 - w d.+2 i.+1) * F d i.+1 by rewrite !mulr_gt0. have f0' : 0 < (1 - w' d.+2 i.+1) * F' d i.+1 by rewrite !mulr_gt0.
have c : lr (w d.+2 i * H d i.+1) (w' d.+2 i * H' d i.+1) ((1 - w d.+2 i.+1) * H d i.+2) ((1 - w' d.+2 i.+1) * H' d i.+2).
  case: (ltnP i.+1 s) => e; last first.
    by rewrite !(@N_supp _ _ s d i.+2) ?mulr0; [exact: lr_zero|move: e; clear; lia|move: e; clear; lia].
  have /andP[x0 x1] := h (e := d.+1) (j := i.+2) ltac:(move: hi lt e; clear; lia).
  have /andP[x0' x1'] := h' (e := d.+1) (j := i.+2) ltac:(move: hi lt e; clear; lia).
  have y0 := n0 (d := d) (i := i.+2) ltac:(move: hi lt e; clear; lia).
  have y0' := n0' (d := d) (i := i.+2) ltac:(move: hi lt e; clear; lia).
  apply: (lr_trans f0 f0') a _; rewrite ?(ltW g0) ?(ltW g0') //; try by rewrite !mulr_ge0 ?subr_ge0 // ltW.
  by apply: lr_scale; rewrite ?(ltW Zp) ?(ltW Zp') //; apply: IH => //; move: hi; clear; lia.
rewrite !NS !mulrDr; case: (leqP s (i + d)) => e; last first.
  rewrite !(@N_supp _ _ s d i) ?mulr0 ?add0r; try (move: e; clear; lia).
  have z := zero_lr.
  have -> : w d.+2 i * ((1 - w d.+1 i.+1) * N w s d i.+1) = 0 + w d.+2 i * H d i.+1 by rewrite add0r.
  have -> : w' d.+2 i * ((1 - w' d.+1 i.+1) * N w' s d i.+1) = 0 + w' d.+2 i * H' d i.+1 by rewrite add0r.
  exact: lr_add2.
have /andP[x0 x1] := h (e := d.+1) (j := i) ltac:(move: hi lt e; clear; lia).
have /andP[x0' x1'] := h' (e := d.+1) (j := i) ltac:(move: hi lt e; clear; lia).
have y0 := n0 (d := d) (i := i) ltac:(move: hi lt e; clear; lia).
have y0' := n0' (d := d) (i := i) ltac:(move: hi lt e; clear; lia).
have q0 : 0 <= w d.+2 i * F d i by rewrite !mulr_ge0 // ltW. have q0' : 0 <= w' d.+2 i * F' d i by rewrite !mulr_ge0 // ltW.
have fg : lr (w d.+2 i * F d i) (w' d.+2 i * F' d i) (w d.+2 i * H d i.+1) (w' d.+2 i * H' d i.+1).
  by apply: lr_scale; rewrite ?ltW //; apply: IH.
have nn : 0 <= (1 - w d.+2 i.+1) * H d i.+2 /\ 0 <= (1 - w' d.+2 i.+1) * H' d i.+2.
  case: (boolP (i.+2 <= s <= i.+2 + d)%N) => e'; last by rewrite !(@N_supp _ _ s d i.+2) ?mulr0.
  have /andP[k0 k1] := h (e := d.+1) (j := i.+2) ltac:(move: e'; clear; lia).
  have /andP[k0' k1'] := h' (e := d.+1) (j := i.+2) ltac:(move: e'; clear; lia).
  by rewrite !mulr_ge0 ?subr_ge0 ?ltW // ?n0 ?n0' ?subr_gt0.
apply: lr_add2 => //.
- by apply: (lr_trans g0 g0') fg a => //; apply: ltW.
- by apply: (lr_trans g0 g0') fg c => //; [case: nn|case: nn].
Qed.
(* G_(i+1)/G_i does not fall from x to y *)
Theorem N_ratio d i : (s <= i + d)%N -> (i < s)%N -> lr (N w s d i) (N w' s d i) (N w s d i.+1) (N w' s d i.+1).
Proof.
move=> hi lt; have st := strong hi lt; rewrite /lr in st *.
have /andP[W0 W1] := h (e := d.+1) (j := i) ltac:(move: hi lt; clear; lia).
have /andP[W0' W1'] := h' (e := d.+1) (j := i) ltac:(move: hi lt; clear; lia).
have hj : inside d.+1 i.+1 by move: hi lt; clear; lia.
have /andP[V0 V1] := h hj; have /andP[V0' V1'] := h' hj.
have p : 0 < w' d.+1 i * (1 - w d.+1 i.+1) by rewrite mulr_gt0 // subr_gt0.
rewrite -(ler_pmul2l p); apply: (@le_trans _ _ (w d.+1 i * (1 - w' d.+1 i.+1) * (N w s d i * N w' s d i.+1))).
  have -> : w' d.+1 i * (1 - w d.+1 i.+1) * (N w' s d i * N w s d i.+1) = F' d i * H d i.+1 by ring.
  by have -> : w d.+1 i * (1 - w' d.+1 i.+1) * (N w s d i * N w' s d i.+1) = F d i * H' d i.+1 by ring.
apply: ler_wpmul2r.
  rewrite mulr_ge0 // ltW //; [apply: n0|apply: n0']; move: hi lt; clear; lia.
by rewrite ler_pmul ?subr_ge0 ?(ltW W0) ?(ltW V1') ?ler_add2l ?ler_opp2 ?le //; move: hi lt; clear; lia.
Qed.
(* any two functions *)
Theorem N_minor d i j : (i <= j)%N -> N w' s d i * N w s d j <= N w s d i * N w' s d j.
Proof.
move=> ij; case: (boolP (i <= s <= i + d)%N) => hi; last by rewrite !(@N_supp _ _ s d i) // !mul0r.
case: (boolP (j <= s <= j + d)%N) => hj; last by rewrite !(@N_supp _ _ s d j) // !mulr0.
rewrite -(subnKC ij) in hj *; move: (j - i)%N hj => a {ij}.
elim: a => [|a IH] hj; first by rewrite addn0 mulrC.
have ha : (i + a <= s <= i + a + d)%N by move: hi hj; clear; lia.
apply: (lr_trans (n0 ha) (n0' ha)); rewrite ?ltW ?n0 ?n0' //; first exact: IH.
by rewrite addnS; apply: N_ratio; move: hi hj; clear; lia.
Qed.
End TwoPoints.

(* the step for the paper's weight: a, b at x; a+z, b-z at y *)
Section Step.
Variable R : realFieldType.
Variable r : R.
Let W a b : R := r * a / (r * a + b).
Let V a b : R := b / (r * a + b).
Lemma step_ineq (a0 a1 b0 b1 z : R) : 0 < r -> 0 < a0 -> a0 <= a1 -> 0 <= z -> z < b0 -> b0 <= b1 ->
  lr (W a1 b0 * V a0 b0) (W (a1 + z) (b0 - z) * V (a0 + z) (b0 - z)) (V a0 b1 * W a0 b0) (V (a0 + z) (b1 - z) * W (a0 + z) (b0 - z)).
Proof.
move=> r0 a00 aa z0 zb bb; rewrite /lr /W /V.
set A0 := a0 + z; set A1 := a1 + z; set B0 := b0 - z; set B1 := b1 - z.
have a10 : 0 < a1 := lt_le_trans a00 aa. have b00 : 0 < b0 := le_lt_trans z0 zb. have b10 : 0 < b1 := lt_le_trans b00 bb.
have A00 : 0 < A0 by rewrite ltr_paddr. have A10 : 0 < A1 by rewrite ltr_paddr.
have B00 : 0 < B0 by rewrite subr_gt0. have B10 : 0 < B1 by rewrite subr_gt0 (lt_le_trans zb).
have den a b : 0 < a -> 0 < b -> 0 < r * a + b by move=> p q; rewrite addr_gt0 // mulr_gt0.
(* after the common factors: a1 b0 (r a0 + b1) against a0 b1 (r a1 + b0) *)
pose X := a1 * b0 * (r * a0 + b1) * (A0 * B1 * (r * A1 + B0)).
pose Y := A1 * B0 * (r * A0 + B1) * (a0 * b1 * (r * a1 + b0)).
have d1 := den a1 b0 a10 b00; have d2 := den a0 b0 a00 b00; have d3 := den a0 b1 a00 b10.
have D1 := den A1 B0 A10 B00; have D2 := den A0 B0 A00 B00; have D3 := den A0 B1 A00 B10.
have -> : r * A1 / (r * A1 + B0) * (B0 / (r * A0 + B0)) * (b1 / (r * a0 + b1) * (r * a0 / (r * a0 + b0))) =
  r ^+ 2 / ((r * a1 + b0) * (r * a0 + b0) * (r * a0 + b1) * ((r * A1 + B0) * (r * A0 + B0) * (r * A0 + B1))) * Y.
  by rewrite /Y; field; rewrite !gt_eqF.
have -> : r * a1 / (r * a1 + b0) * (b0 / (r * a0 + b0)) * (B1 / (r * A0 + B1) * (r * A0 / (r * A0 + B0))) =
  r ^+ 2 / ((r * a1 + b0) * (r * a0 + b0) * (r * a0 + b1) * ((r * A1 + B0) * (r * A0 + B0) * (r * A0 + B1))) * X.
  by rewrite /X; field; rewrite !gt_eqF.
apply: ler_wpmul2l; first by rewrite divr_ge0 ?exprn_ge0 ?(ltW r0) // !mulr_ge0 // ltW.
rewrite -subr_ge0.
have -> : X - Y = z * (r ^+ 2 * ((b1 - b0) * (a0 * A0 * (a1 * A1))) + (a1 - a0) * (b0 * B0 * (b1 * B1))
   + r * ((a0 + b0) * (a1 * A1) * (b1 * B1) - (a1 + b1) * (a0 * A0) * (b0 * B0))).
  by rewrite /X /Y /A0 /A1 /B0 /B1; ring.
have r00 := ltW r0; have a00' := ltW a00; have a10' := ltW a10; have b00' := ltW b00; have b10' := ltW b10.
have A00' := ltW A00; have A10' := ltW A10; have B00' := ltW B00; have B10' := ltW B10.
apply: mulr_ge0 => //; apply: addr_ge0; first apply: addr_ge0.
- by apply: mulr_ge0; [exact: sqr_ge0|apply: mulr_ge0; [rewrite subr_ge0|rewrite !mulr_ge0]].
- by apply: mulr_ge0; [rewrite subr_ge0|rewrite !mulr_ge0].
apply: mulr_ge0 => //.
have -> : (a0 + b0) * (a1 * A1) * (b1 * B1) - (a1 + b1) * (a0 * A0) * (b0 * B0) =
  a1 * b1 * (a0 + b0) * (A1 * B1) - a0 * b0 * (a1 + b1) * (A0 * B0) by ring.
rewrite subr_ge0; apply: ler_pmul; [by rewrite !mulr_ge0 ?addr_ge0|by rewrite mulr_ge0| |].
  have -> : a0 * b0 * (a1 + b1) = a0 * a1 * b0 + a0 * (b0 * b1) by ring.
  have -> : a1 * b1 * (a0 + b0) = a0 * a1 * b1 + a1 * (b0 * b1) by ring.
  by apply: ler_add; [rewrite ler_wpmul2l ?mulr_ge0|rewrite ler_wpmul2r ?mulr_ge0].
by rewrite ler_pmul // /A0 /A1 /B0 /B1 ler_add2r.
Qed.
End Step.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Section Span.
Variable s : nat.
Lemma open_minor d i j x y : (i <= j)%N -> t s < x -> x <= y -> y < t s.+1 ->
  P r t s d i y * P r t s d j x <= P r t s d i x * P r t s d j y.
Proof.
move=> ij sx xy ys.
have hx : t s < x < t s.+1 by rewrite sx (le_lt_trans xy). have hy : t s < y < t s.+1 by rewrite ys (lt_le_trans sx).
have ss : t s < t s.+1 by apply: lt_trans sx (le_lt_trans xy ys).
apply: (@N_minor R (fun e j => mw r t e j x) (fun e j => mw r t e j y) s) => //.
- by move=> e l; apply: span_in.
- by move=> e l; apply: span_in.
- move=> e l hl; have /andP[p q] := hl; apply: mob_x => //; last exact: (span_ab t_mono ss hl).
    exact: le_trans (tle p) (ltW sx).
  exact: le_trans (ltW ys) (tle q).
move: d i ij => d0 i0 _ d i hi; have /andP[i1 i2] := hi.
have E e l u : mw r t e l u = r * (u - t l) / (r * (u - t l) + (t (l + e)%N - u)) by [].
have C e l u : t l <= u -> u <= t (l + e)%N -> t l < t (l + e)%N ->
    1 - mw r t e l u = (t (l + e)%N - u) / (r * (u - t l) + (t (l + e)%N - u)) by move=> *; apply: mob_compl.
have p1 : t i.+1 <= t s by apply: tle. have p0 : t i <= t i.+1 by [].
have e1 : (i.+1 + d.+1 = i + d.+2)%N by clear; lia. have e2 : (i.+1 + d.+2 = (i + d.+2).+1)%N by clear; lia.
have p2 : t s.+1 <= t (i + d.+2)%N by apply: tle. have p3 : t (i + d.+2)%N <= t (i + d.+2).+1 by [].
have lt1 : t i.+1 < t (i + d.+2)%N by apply: (le_lt_trans p1 (lt_le_trans ss p2)).
have lt2 : t i.+1 < t (i + d.+2).+1 by apply: lt_le_trans lt1 p3.
have bx : t i.+1 <= x /\ x <= t (i + d.+2)%N by rewrite (le_trans p1 (ltW sx)) (le_trans (le_trans xy (ltW ys)) p2).
have by_ : t i.+1 <= y /\ y <= t (i + d.+2)%N by rewrite (le_trans p1 (le_trans (ltW sx) xy)) (le_trans (ltW ys) p2).
case: bx => bx1 bx2; case: by_ => by1 by2.
rewrite !C ?e1 ?e2 ?(le_trans bx2 p3) ?(le_trans by2 p3) // !E e1.
have Y1 l : y - t l = (x - t l) + (y - x) by ring.
have Y2 l : t l - y = (t l - x) - (y - x) by ring.
rewrite !Y1 !Y2; apply: step_ineq => //.
- by rewrite subr_gt0 (le_lt_trans p1).
- by rewrite ler_add2l ler_opp2.
- by rewrite subr_ge0.
- by rewrite ltr_add2r (lt_le_trans ys).
- by rewrite ler_add2r.
Qed.
(* on the closed span, by continuity *)
Lemma limit_ge0 (f : R -> R) v l e : taylor f 0 v l -> 0 < e -> (forall h, 0 < h < e -> 0 <= f h) -> 0 <= v.
Proof.
move=> tf e0 H; rewrite leNgt; apply/negP => v0.
have [|d d0 Hd] := taylor_pos (taylor_scale (-1) tf); first by left; rewrite mulN1r oppr_gt0.
have m0 : 0 < Num.min e d by rewrite lt_minr e0.
have hm : 0 < Num.min e d / 2%:R < Num.min e d by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
move: hm => /andP[h0]; rewrite lt_minr => /andP[h1 h2].
by have := Hd _ (introT andP (conj h0 h2)); rewrite mulN1r oppr_gt0 ltNge H ?h0.
Qed.
Lemma taylor_shift (f : R -> R) x v l c : taylor f x v l -> taylor (fun h => f (x + c * h)) 0 v (c * l).
Proof.
move=> [g [d [[C [e [C0 e0 gC]]] d0 hf]]].
have c0 : 0 < `|c| + 1 by rewrite ltr_paddl.
have small a h : 0 < a -> `|h| < a / (`|c| + 1) -> `|c * h| < a.
  move=> a0; rewrite ltr_pdivl_mulr // => hh; rewrite normrM; apply: le_lt_trans hh.
  by rewrite mulrC ler_wpmul2l // ler_addl ler01.
exists (fun h => c ^+ 2 * g (c * h)), (d / (`|c| + 1)); split.
- exists (c ^+ 2 * C), (e / (`|c| + 1)); split; [by rewrite mulr_ge0 ?sqr_ge0|by rewrite divr_gt0|].
  by move=> h hh; rewrite normrM ger0_norm ?sqr_ge0 // ler_wpmul2l ?sqr_ge0 // gC // small.
- by rewrite divr_gt0.
by move=> h hh; rewrite add0r hf ?small //; ring.
Qed.
(* the minor of two functions at two points of a closed span is not negative, by continuity from inside *)
Theorem closed_minor d i j x y : t s < t s.+1 -> (i <= j)%N -> t s <= x -> x <= y -> y <= t s.+1 ->
  P r t s d i y * P r t s d j x <= P r t s d i x * P r t s d j y.
Proof.
move=> ss ij sx xy ys; rewrite -subr_ge0.
pose mid := (t s + t s.+1) / 2%:R.
have /andP[m1 m2] : t s < mid < t s.+1 by rewrite !midf_lt.
(* both points move towards the middle *)
pose fx h := x + (mid - x) * h; pose fy h := y + (mid - y) * h.
have hx : t s <= x <= t s.+1 by rewrite sx (le_trans xy). have hy : t s <= y <= t s.+1 by rewrite ys (le_trans sx).
have TT_ l z : t s <= z <= t s.+1 -> taylor (fun h => P r t s d l (z + (mid - z) * h)) 0 (P r t s d l z) ((mid - z) * dP r t s d l z).
  by move=> hz; apply: taylor_shift; apply: P_taylor.
have D := taylor_add (taylor_mul (TT_ i x hx) (TT_ j y hy)) (taylor_scale (-1) (taylor_mul (TT_ i y hy) (TT_ j x hx))).
rewrite -mulN1r; apply: (limit_ge0 D ltr01) => h /andP[h0 h1] /=.
rewrite mulN1r subr_ge0; have k0 : 0 < 1 - h by rewrite subr_gt0.
have F z : z + (mid - z) * h = (1 - h) * z + h * mid by ring.
rewrite !F; apply: open_minor => //.
- have -> : t s = (1 - h) * t s + h * t s by ring.
  by rewrite ler_lt_add ?ler_pmul2l ?ltr_pmul2l.
- by rewrite ler_add2r ler_pmul2l.
have -> : t s.+1 = (1 - h) * t s.+1 + h * t s.+1 by ring.
by rewrite ler_lt_add ?ler_pmul2l ?ltr_pmul2l.
Qed.
(* where the points meet: the derivative of P_j/P_i, times P_i^2, is not negative inside of the span *)
Theorem span_ratio d i j x : (i <= j)%N -> t s < x < t s.+1 -> dP r t s d i x * P r t s d j x <= P r t s d i x * dP r t s d j x.
Proof.
move=> ij /andP[sx xs]; have hx : t s <= x <= t s.+1 by rewrite !ltW.
have T l : taylor (fun h => P r t s d l (x + 1 * h)) 0 (P r t s d l x) (1 * dP r t s d l x).
  by apply: taylor_shift; apply: P_taylor => //; apply: lt_trans xs.
rewrite leNgt -subr_gt0; apply/negP => lt.
(* the minor of x and x+h, negated, begins with this term *)
have D := taylor_add (taylor_scale (P r t s d j x) (T i)) (taylor_scale (- P r t s d i x) (T j)).
have [|e e0 H] := taylor_pos D; first by right; rewrite !mul1r; split; [ring|rewrite mulNr mulrC].
have m0 : 0 < Num.min e (t s.+1 - x) by rewrite lt_minr e0 subr_gt0.
have := H (Num.min e (t s.+1 - x) / 2%:R); set h := _ / _.
have /andP[h0] : 0 < h < Num.min e (t s.+1 - x) by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
rewrite lt_minr => /andP[h1 h2]; rewrite h0 h1 mul1r => /(_ isT); rewrite mulNr subr_gt0 ltNge.
by rewrite mulrC open_minor // ?ler_addl ?(ltW h0) // addrC -ltr_subr_addr.
Qed.
(* on a span the functions and their derivatives from the right are those of its piece *)
Lemma value_span m k i x : (s < m)%N -> t s <= x < t s.+1 -> value r t m k i x = P r t s k i x.
Proof. by move=> sm hx; rewrite value_in; [exact: G_P|case/andP: hx => _ h; apply: lt_le_trans h (tle sm)]. Qed.
Lemma DGright_span m k i x : (s < m)%N -> t s <= x < t s.+1 -> DGright r t m k i x = dP r t s k i x.
Proof.
move=> sm hx; have /andP[s1 s2] := hx; rewrite DGright_in; first by rewrite /Dright (right_span_uniq t_mono sm hx).
by rewrite (le_trans (tle (leq0n s)) s1) (lt_le_trans s2 (tle sm)).
Qed.
End Span.
(* X.minors: inside of a span G_(i+1)/G_i does not fall, all knots: G_i' G_(i+1) <= G_i G_(i+1)' *)
Theorem X_minors_printed n k l i x : (l < n + k.+1)%N -> (i < n)%N -> t l < x < t l.+1 ->
  DGright r t (n + k.+1)%N k i x * value r t (n + k.+1)%N k i.+1 x <= value r t (n + k.+1)%N k i x * DGright r t (n + k.+1)%N k i.+1 x.
Proof.
move=> lm _ hx; have hx' : t l <= x < t l.+1 by case/andP: hx => /ltW -> ->.
by rewrite !(value_span _ _ lm hx') !(DGright_span _ _ lm hx'); apply: span_ratio.
Qed.
(* across the spans *)
Section Global.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Hypothesis inner : Uinner t n k.
Lemma P_ge0 s i x : t s < t s.+1 -> t s <= x <= t s.+1 -> 0 <= P r t s k i x.
Proof. by move=> ss hx; apply: N_ge0 => e j; apply: (span_01 t_mono ss r_gt0 hx). Qed.
Lemma spans_minor i j s s' x y : (i <= j)%N -> (s' < m)%N -> (s <= s')%N -> t s < t s.+1 -> t s' < t s'.+1 ->
  t s <= x <= t s.+1 -> t s' <= y <= t s'.+1 -> x <= y -> P r t s' k i y * P r t s k j x <= P r t s k i x * P r t s' k j y.
Proof.
move=> ij sm; have [a] := ubnP (s' - s)%N; elim: a s x => // a IH s x; rewrite ltnS => la le h h' hx hy xy.
have /andP[x1 x2] := hx; have /andP[y1 y2] := hy.
move: le; rewrite leq_eqVlt => /orP[/eqP e|lt].
  by rewrite -e in y1 y2 *; apply: closed_minor.
have rhs : 0 <= P r t s k i x * P r t s' k j y by rewrite mulr_ge0 ?P_ge0.
case: (boolP (j <= s <= j + k)%N) => hj; last by rewrite [P r t s k j x]N_supp // mulr0.
case: (boolP (i <= s' <= i + k)%N) => hi; last by rewrite [P r t s' k i y]N_supp // mul0r.
set z := t s.+1; have zs' : z <= t s' by apply: tle.
have [s'' [/andP[a1 a2] /andP[b1 b2]]] := @span_exists R t t_mono s.+1 s'.+1 z ltac:(rewrite lexx; exact: le_lt_trans zs' h').
have hz : t 0%N < z < t m.
  rewrite (le_lt_trans (tle (leq0n s)) h) (le_lt_trans zs') // (lt_le_trans h') //; exact: tle.
have gz l : G (wt r t) t k l z = P r t s k l z.
  have [p [p1 p2 pm ->]] := P3_1_2_paper r_gt0 t_mono l hz (inner hz).
  by rewrite -(left_span_uniq t_mono pm (x := z)) ?p1 // (left_span_uniq t_mono (s := s)) ?h ?lexx //; move: lt sm; clear; lia.
have gz' l : G (wt r t) t k l z = P r t s'' k l z by apply: G_P => //; rewrite b1.
have pos l : (l <= s)%N -> (i <= l)%N -> 0 < P r t s k l z.
  move=> ls il; rewrite -gz; apply: T3_5_2 => //; [exact: wt_left|exact: wt_range|exact: wt_inside|].
  rewrite (le_lt_trans (tle ls) h) /=; apply: (le_lt_trans zs'); apply: (lt_le_trans h'); apply: tle.
  by move: hi il; clear; lia.
have A0 : 0 < P r t s k i z by apply: pos => //; move: hj ij; clear; lia.
have B0 : 0 < P r t s k j z by apply: pos => //; case/andP: hj.
have s1 := closed_minor k h ij x1 x2 (lexx _).
have s2 : P r t s' k i y * P r t s'' k j z <= P r t s'' k i z * P r t s' k j y.
  apply: IH => //; last exact: le_trans zs' y1.
  - by move: la a1 a2; clear; lia.
  - exact: le_lt_trans b1 b2.
  - by rewrite b1 ltW.
rewrite -!gz' !gz in s2; rewrite -(ler_pmul2l (mulr_gt0 A0 B0)).
have -> : P r t s k i z * P r t s k j z * (P r t s' k i y * P r t s k j x) = (P r t s k i z * P r t s k j x) * (P r t s' k i y * P r t s k j z) by ring.
have -> : P r t s k i z * P r t s k j z * (P r t s k i x * P r t s' k j y) = (P r t s k i x * P r t s k j z) * (P r t s k i z * P r t s' k j y) by ring.
apply: ler_pmul => //; rewrite mulr_ge0 ?(ltW A0) ?(ltW B0) ?P_ge0 //.
Qed.
(* every minor of two rows and two columns of the matrix of all G_i(x_j) is non-negative *)
Theorem minors_2 i j x y : t 0%N < t m -> (i < j <= n)%N -> t 0%N <= x -> x < y -> y <= t m ->
  0 <= value r t m k i x * value r t m k j y - value r t m k i y * value r t m k j x.
Proof.
move=> U /andP[ij jn] x0 xy ym; rewrite subr_ge0.
have xm : x < t m := lt_le_trans xy ym.
have [sm /andP[s1 s2]] := right_spanP (introT andP (conj x0 xm)); set s := right_span t m x in sm s1 s2.
have V l : value r t m k l x = P r t s k l x by rewrite value_in // (G_P r t_mono k l (s := s)) ?s1.
have ss := le_lt_trans s1 s2.
move: ym; rewrite le_eqVlt => /orP[/eqP e|lt].
  have [p1 p2 p3] := last_spanP t_mono U.
  have V' l : value r t m k l y = P r t (last_span t m) k l y by rewrite e value_tm.
  have le : (s <= last_span t m)%N.
    by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite p3; exact: le_lt_trans s1 xm.
  have hy : t (last_span t m) <= y <= t (last_span t m).+1.
    by rewrite e p3 lexx andbT -p3 ltW.
  have hx : t s <= x <= t s.+1 by rewrite s1 ltW.
  rewrite !V !V'; exact: (spans_minor (ltnW ij) p1 le ss p2 hx hy (ltW xy)).
have y0 : t 0%N <= y := le_trans x0 (ltW xy).
have [sm' /andP[s1' s2']] := right_spanP (introT andP (conj y0 lt)); set s' := right_span t m y in sm' s1' s2'.
have V' l : value r t m k l y = P r t s' k l y by rewrite value_in // (G_P r t_mono k l (s := s')) ?s1'.
have le : (s <= s')%N.
  by rewrite -ltnS; apply: (t_lt_ltn t_mono); apply: (le_lt_trans s1); apply: (lt_trans xy).
have hx : t s <= x <= t s.+1 by rewrite s1 ltW.
have hy : t s' <= y <= t s'.+1 by rewrite s1' ltW.
have ss' := le_lt_trans s1' s2'.
rewrite !V !V'; exact: (spans_minor (ltnW ij) sm' le ss ss' hx hy (ltW xy)).
Qed.
(* control values that change sign at most once, from - to +, make a curve that does so *)
Theorem one_crossing (d : nat -> R) l x y : t 0%N < t m -> (forall i, (i <= l)%N -> d i <= 0) -> (forall i, (l < i <= n)%N -> 0 <= d i) ->
  t 0%N <= x -> x < y -> y <= t m -> 0 < coordinate r t n k d x -> 0 <= coordinate r t n k d y.
Proof.
move=> U neg pos x0 xy ym; case: (leqP n l) => ln.
  have s0 : coordinate r t n k d x <= 0.
    rewrite /coordinate -oppr_ge0 -sumrN big_nat_cond; apply: sumr_ge0 => i /andP[/andP[_ im] _].
    by rewrite -mulNr mulr_ge0 ?oppr_ge0 ?neg ?value_ge0 //; move: im ln; clear; lia.
  by rewrite ltNge s0.
have S z : coordinate r t n k d z = \sum_(l.+1 <= j < n.+1) d j * value r t m k j z - \sum_(0 <= i < l.+1) - d i * value r t m k i z.
  rewrite /coordinate (big_cat_nat _ (n := l.+1)) //=; last exact: ltnW.
  by rewrite addrC; congr (_ + _); rewrite -sumrN; apply: eq_bigr => i _; rewrite mulNr opprK.
rewrite !S; set A := fun z => \sum_(0 <= i < l.+1) - d i * value r t m k i z; set B := fun z => \sum_(l.+1 <= j < n.+1) d j * value r t m k j z.
rewrite -/(A x) -/(A y) -/(B x) -/(B y).
have A0 z : 0 <= A z.
  rewrite /A big_nat_cond; apply: sumr_ge0 => i /andP[/andP[_ il] _].
  by rewrite mulr_ge0 ?oppr_ge0 ?neg ?value_ge0 //; move: il ln; clear; lia.
have M : A y * B x <= A x * B y.
  rewrite /A /B !mulr_suml big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[/andP[_ il] _].
  rewrite !mulr_sumr big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => j /andP[/andP[lj jn] _].
  have ij : (i < j <= n)%N by move: il lj jn; clear; lia.
  have h := minors_2 U ij x0 xy ym; rewrite subr_ge0 in h.
  have -> : - d i * value r t m k i y * (d j * value r t m k j x) = - d i * d j * (value r t m k i y * value r t m k j x) by ring.
  have -> : - d i * value r t m k i x * (d j * value r t m k j y) = - d i * d j * (value r t m k i x * value r t m k j y) by ring.
  by rewrite ler_wpmul2l // mulr_ge0 ?oppr_ge0 ?neg ?pos //; move: il lj jn; clear; lia.
rewrite subr_gt0 => h; rewrite subr_ge0.
have Bx : 0 < B x := le_lt_trans (A0 x) h.
case: (leP 0 (B y)) => By; last first.
  have := le_trans M (mulr_ge0_le0 (A0 x) (ltW By)); rewrite pmulr_lle0 // => Ay.
  have Ay0 : A y = 0 by apply/eqP; rewrite eq_le Ay A0.
  have By0 : 0 <= B y.
    rewrite /B big_nat_cond; apply: sumr_ge0 => j /andP[/andP[lj jn] _].
    by rewrite mulr_ge0 ?pos ?value_ge0 //; move: lj jn; clear; lia.
  by move: By; rewrite ltNge By0.
rewrite -(ler_pmul2r Bx); apply: le_trans M _; rewrite mulrC ler_wpmul2l // ltW //.
Qed.
End Global.
End Paper.
