(* X.close: how far a curve is from the classical one, and from that for another index. One step of the recursion adds at most the
   largest difference of two weights, because the weights fall with their index. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Values StatementsBasis StatementsCurves Cumulative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Steps.
Variable R : realFieldType.
Lemma sum_mix (c e : nat -> R) b : (forall i, 0 <= c i <= 1) -> (forall i, c i.+1 <= c i) -> (forall i, 0 <= e i) ->
  \sum_(0 <= i < b.+1) (c i * e i + (1 - c i) * e i.+1) <= \sum_(0 <= i < b.+1) e i + (1 - c b) * e b.+1.
Proof.
move=> h01 hc he; elim: b => [|b IH].
  rewrite !big_nat1 ler_add2r -[X in _ <= X]mul1r ler_wpmul2r //; by case/andP: (h01 0%N).
rewrite big_nat_recr //= [X in _ <= X + _]big_nat_recr //= addrA ler_add2r.
apply: le_trans (ler_add IH (lexx _)) _; rewrite -addrA ler_add2l -mulrDl.
by rewrite -[X in _ <= X]mul1r ler_wpmul2r // -subr_ge0 opprD opprB addrA [1 + _]addrC subrK subr_ge0.
Qed.

Variables (w w' : nat -> nat -> R) (s : nat) (D : R).
Local Notation inside d i := (i <= s < i + d)%N.
Hypothesis D0 : 0 <= D.
Hypothesis h : forall e j, inside e j -> 0 <= w e j <= 1.
Hypothesis h' : forall e j, inside e j -> 0 <= w' e j <= 1.
Hypothesis hD : forall e j, inside e j -> `|w' e j - w e j| <= D.
Hypothesis fall : forall e j, inside e j -> inside e j.+1 -> w' e j.+1 <= w' e j.
Let c d i : R := if inside d i then w' d i else (i <= s)%N%:R.
Lemma c01 d i : 0 <= c d i <= 1.
Proof. by rewrite /c; case: ifP => [/h'//|_]; rewrite ler0n lern1 leq_b1. Qed.
Lemma c_fall d i : c d i.+1 <= c d i.
Proof.
rewrite {1}/c; case: ifP => [hi|hi].
  rewrite /c; case: ifP => [hj|hj]; first exact: fall.
  have -> : (i <= s)%N by move: hi; clear; lia.
  by have /andP[] := h' hi.
case: (leqP i.+1 s) => is_; last by case/andP: (c01 d i).
rewrite /c; case: ifP => [hj|_]; last by rewrite ltnW.
by move: hi hj is_; clear; lia.
Qed.
(* the sum of all |T' - T| is at most d times the largest difference of two weights *)
Theorem T_distance d b : (s < b)%N -> \sum_(0 <= i < b) `|T w' s d i - T w s d i| <= d%:R * D.
Proof.
case: b => // b sb; elim: d => [|d IH].
  by rewrite mul0r big1 // => i _; rewrite subrr normr0.
pose e i := `|T w' s d i - T w s d i|.
have step i : `|T w' s d.+1 i - T w s d.+1 i| <= (c d.+1 i * e i + (1 - c d.+1 i) * e i.+1) + D * N w s d i.
  have /andP[a1 a2] := c01 d.+1 i; have n0 : 0 <= N w s d i by apply: N_ge0.
  case: (boolP (inside d.+1 i)) => hi; last first.
    have -> : T w' s d.+1 i - T w s d.+1 i = 0.
      case: (ltnP s i) => si; first by rewrite !T_high // subrr.
      by rewrite !T_low ?subrr //; move: hi si; clear; lia.
    by rewrite normr0 !addr_ge0 // mulr_ge0 ?normr_ge0 ?subr_ge0.
  rewrite T_diff; have -> : c d.+1 i = w' d.+1 i by rewrite /c hi.
  have /andP[b1 b2] := h' hi.
  apply: le_trans (ler_norm_add _ _) _; apply: ler_add.
    apply: le_trans (ler_norm_add _ _) _; by rewrite !normrM (ger0_norm b1) (@ger0_norm _ (1 - w' d.+1 i)) ?subr_ge0.
  by rewrite normrM (ger0_norm n0) ler_wpmul2r // hD.
have eb : e b.+1 = 0 by rewrite /e !T_high ?subrr ?normr0 // ltnW.
apply: (@le_trans _ _ (\sum_(0 <= i < b.+1) ((c d.+1 i * e i + (1 - c d.+1 i) * e i.+1) + D * N w s d i))).
  by apply: ler_sum => i _; exact: step.
have -> : d.+1%:R * D = d%:R * D + D by rewrite -[d.+1]addn1 natrD mulrDl mul1r.
rewrite big_split /=; apply: ler_add.
  have mix := @sum_mix (c d.+1) e b (c01 d.+1) (c_fall d.+1) (fun i => normr_ge0 _).
  by apply: (le_trans mix); rewrite eb mulr0 addr0.
rewrite -mulr_sumr (T_sum w d sb) // -[X in _ <= X]mulr1 ler_wpmul2l //.
by case/andP: (@T_01 R w s d 0%N h).
Qed.
End Steps.

(* the weights fall with their index *)
Lemma mob_ab (R : realFieldType) (r x a b a' b' : R) : 0 < r -> a <= a' -> b <= b' -> a' <= x -> x <= b -> a < b -> a' < b' ->
  mob r x a' b' <= mob r x a b.
Proof.
move=> r0 aa bb ax xb ab ab'; have d1 := mob_den_gt0 r0 (le_trans aa ax) xb ab; have d2 := mob_den_gt0 r0 ax (le_trans xb bb) ab'.
rewrite /mob ler_pdivr_mulr // mulrAC ler_pdivl_mulr // -subr_ge0.
have -> : r * (x - a) * (r * (x - a') + (b' - x)) - r * (x - a') * (r * (x - a) + (b - x)) =
  r * ((x - a') * (b' - b) + (a' - a) * (b' - x)) by ring.
by rewrite mulr_ge0 ?(ltW r0) // addr_ge0 // mulr_ge0 ?subr_ge0 // (le_trans xb).
Qed.

Section Close.
Variable R : rcfType.
Definition delta (r : R) : R := `|Num.sqrt r - 1| / (Num.sqrt r + 1).
Lemma sqrt1_gt0 (r : R) : 0 < Num.sqrt r + 1.
Proof. by rewrite ltr_paddl ?sqrtr_ge0. Qed.
Lemma delta_ge0 (r : R) : 0 <= delta r.
Proof. by rewrite divr_ge0 ?normr_ge0 // ltW // sqrt1_gt0. Qed.
(* Ill2.1.crucial, its first line: no weight is farther than delta from the classical one *)
Theorem weight_distance (r x a b : R) : 0 < r -> a <= x -> x <= b -> a < b -> `|mob r x a b - mob 1 x a b| <= delta r.
Proof.
move=> r0 ax xb ab; have d1 := mob_den_gt0 r0 ax xb ab; have d2 := mob_den_gt0 (@ltr01 R) ax xb ab.
have q2 : Num.sqrt r ^+ 2 = r by rewrite sqr_sqrtr // ltW.
have q0 := sqrtr_ge0 r; have s0 := sqrt1_gt0 r; rewrite /delta.
move: (Num.sqrt r) q2 q0 s0 => q q2 q0 s0; rewrite -q2 in d1 *.
set u := x - a in d1 d2 *; set v := b - x in d1 d2 *.
rewrite mul1r in d2; have u0 : 0 <= u by rewrite subr_ge0. have v0 : 0 <= v by rewrite subr_ge0.
have -> : mob (q ^+ 2) x a b - mob 1 x a b = (q - 1) * ((q + 1) * (u * v)) / ((q ^+ 2 * u + v) * (u + v)).
  have n1 : q ^+ 2 * u + v != 0 by rewrite gt_eqF.
  have n2 : u + v != 0 by rewrite gt_eqF.
  by rewrite /mob -/u -/v mul1r; field; rewrite n1 n2.
rewrite normrM [X in _ * X <= _]gtr0_norm ?invr_gt0 ?mulr_gt0 // normrM [X in _ * X / _ <= _]ger0_norm; last by rewrite !mulr_ge0 // ltW.
rewrite ler_pdivr_mulr ?mulr_gt0 // mulrAC ler_pdivl_mulr // -mulrA; apply: ler_wpmul2l; first exact: normr_ge0.
rewrite -subr_ge0; have -> : (q ^+ 2 * u + v) * (u + v) - (q + 1) * (u * v) * (q + 1) = (q * u - v) ^+ 2 by ring.
exact: sqr_ge0.
Qed.

Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Variable r : R.
Hypothesis r0 : 0 < r.
Lemma TT_distance s x : (s <= n)%N -> t s < t s.+1 -> t s <= x <= t s.+1 ->
  \sum_(1 <= i < n.+1) `|TT t s r k i x - TT t s 1 k i x| <= k%:R * delta r.
Proof.
move=> sn ss hx; have /andP[x1 x2] := hx.
have b1 e j : (j <= s < j + e)%N -> t j <= x by move=> /andP[a _]; exact: le_trans (tle a) x1.
have b2 e j : (j <= s < j + e)%N -> x <= t (j + e)%N by move=> /andP[_ a]; exact: le_trans x2 (tle a).
have := @T_distance R (fun e j => mw 1 t e j x) (fun e j => mw r t e j x) s (delta r) (delta_ge0 r)
  (fun e j => @span_01 R t t_mono s ss 1 x e j ltr01 hx) (fun e j => @span_01 R t t_mono s ss r x e j r0 hx) _ _ k n.+1 sn.
rewrite big_ltn // => H; apply: le_trans (H _ _); first by rewrite ler_addr normr_ge0.
  move=> e j hj; apply: weight_distance => //; [exact: b1 hj|exact: b2 hj|exact: (span_ab t_mono ss hj)].
move=> e j hj hj'; apply: mob_ab => //; [by rewrite addSn|exact: b1 hj'|exact: b2 hj|exact: (span_ab t_mono ss hj)|].
exact: (span_ab t_mono ss hj').
Qed.
(* X.close, its first line, on [t_k, t_(n+1)) *)
Theorem X_close_bound x : t k <= x < t n.+1 ->
  \sum_(1 <= i < n.+1) `|\sum_(i <= j < n.+1) (value r t m k j x - value 1 t m k j x)| <= k%:R * delta r.
Proof.
move=> hx; have [s [/andP[ks sn] hs]] := span_exists t_mono hx.
have ss : t s < t s.+1 by have /andP[a b] := hs; apply: le_lt_trans b.
have hs' : t s <= x <= t s.+1 by have /andP[-> /ltW ->] := hs.
rewrite ltnS in sn; apply: le_trans (TT_distance sn ss hs'); rewrite big_nat_cond [X in _ <= X]big_nat_cond.
apply: ler_sum => i /andP[/andP[_ hi] _]; rewrite sumrB !(@sum_TT R t t_mono n k _ s) //; try (move: sn hi; clear; lia).
Qed.
(* so the curve is at most k delta times the largest |d_i - d_(i-1)| away from the classical one *)
Theorem X_close_curve d M x : t k <= x < t n.+1 -> (forall i, (1 <= i <= n)%N -> `|d i - d i.-1| <= M) ->
  `|coordinate r t n k d x - coordinate 1 t n k d x| <= k%:R * delta r * M.
Proof.
move=> hx hM; have [s [/andP[ks sn] hs]] := span_exists t_mono hx.
have ss : t s < t s.+1 by have /andP[a b] := hs; apply: le_lt_trans b.
have hs' : t s <= x <= t s.+1 by have /andP[-> /ltW ->] := hs.
rewrite ltnS in sn; rewrite !(@C_abel R t t_mono n k _ d s) ?ks ?sn //.
have -> : forall a b e : R, a + b - (a + e) = b - e by move=> a b e; ring.
rewrite -sumrB; apply: le_trans (ler_norm_sum _ _ _) _.
have M0 : (0 < n)%N -> 0 <= M by move=> n0; apply: le_trans (hM 1%N _); rewrite ?normr_ge0.
case: (posnP n) => [n0|/M0 {}M0].
  by move: hM; rewrite n0 big_geq // => _; rewrite (_ : k = 0%N) ?mul0r //; move: ks sn; rewrite n0; clear; lia.
apply: (@le_trans _ _ (\sum_(1 <= i < n.+1) M * `|TT t s r k i x - TT t s 1 k i x|)).
  rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[hi _].
  by rewrite -mulrBr normrM ler_wpmul2r ?normr_ge0 // hM //; move: hi; clear; lia.
by rewrite -mulr_sumr mulrC ler_wpmul2r // TT_distance.
Qed.
End Close.
