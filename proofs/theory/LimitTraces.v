(* X.limit.trace and X.limit.arc: how far the curve is, for small and for large r, from segments of its polygon and from the arcs at its ends. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsDerivatives Cumulative Distance.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Bounds.
Variable R : realFieldType.
Variables (w : nat -> nat -> R) (s : nat).
Hypothesis h : forall e j, (j <= s < j + e)%N -> 0 <= w e j <= 1.
(* T_(s-c)^d is at most the sum of the weights down to T_(s+1) *)
Lemma T_down d c : (c < d)%N -> (c <= s)%N -> T w s d (s - c) <= \sum_(0 <= e < c.+1) w (d - c + e)%N (s - e)%N.
Proof.
have le (a b : R) : 0 <= a -> b <= 1 -> a * b <= a by move=> a0 b1; rewrite -[X in _ <= X]mulr1 ler_wpmul2l.
elim: c d => [|c IH] [|d] // cd cs.
  rewrite subn0 big_nat1 addn0 !subn0 TS [T w s d s.+1]T_high // mulr0 addr0.
  have hs : (s <= s < s + d.+1)%N by clear; lia.
  have /andP[a b] := h hs; have /andP[_ b'] := @T_01 R w s d s h; exact: le.
have hs : (s - c.+1 <= s < s - c.+1 + d.+1)%N by move: cd cs; clear; lia.
have /andP[a b] := h hs; have /andP[_ b'] := @T_01 R w s d (s - c.+1) h; have /andP[a1 _] := @T_01 R w s d (s - c) h.
rewrite TS big_nat_recr //= [X in _ <= X]addrC; have -> : ((s - c.+1).+1 = s - c)%N by move: cs; clear; lia.
have -> : (d.+1 - c.+1 + c.+1 = d.+1)%N by move: cd; clear; lia.
apply: ler_add; first exact: le.
apply: le_trans (IH d cd (ltnW cs)); rewrite -[X in _ <= X]mul1r ler_wpmul2r // ler_subl_addl ler_addr //.
Qed.
(* and 1 - T_i^d at most that of their complements *)
Lemma T_up i p d : (i + p = s)%N -> 1 - T w s (p + d) i <= \sum_(0 <= e < d) (1 - w (p + e).+1 i).
Proof.
move=> e; elim: d => [|d IH]; first by rewrite big_geq // addn0 T_low ?subrr // e.
have hs : (i <= s < i + (p + d).+1)%N by move: e; clear; lia.
have /andP[a b] := h hs; have /andP[a1 b1] := @T_01 R w s (p + d) i h; have /andP[a2 b2] := @T_01 R w s (p + d) i.+1 h.
rewrite addnS TS big_nat_recr //=; apply: le_trans (ler_add IH (lexx _)).
move: (w _ i) (T w s _ i) (T w s _ i.+1) a b a1 b1 a2 b2 => u v v' a b a1 b1 a2 b2.
rewrite -subr_ge0; have -> : 1 - v + (1 - u) - (1 - (u * v + (1 - u) * v')) = (1 - u) * (1 - v) + (1 - u) * v' by ring.
by rewrite addr_ge0 // mulr_ge0 ?subr_ge0.
Qed.
End Bounds.

Section Trace.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Local Notation value := (value r t m).
(* with fewer than k copies a knot at the end of a span is inside, and its copies are the knots next to the span *)
Lemma copies_right j : (k <= j <= n)%N -> t j < t j.+1 -> (mult t m (t j.+1) < k)%N -> t j.+1 < t (j.+1 + mult t m (t j.+1))%N.
Proof.
move=> /andP[kj jn] h hk; have h0 : t 0%N < t j.+1 := le_lt_trans (tle (leq0n j)) h.
have jm : (j.+1 <= m)%N by move: jn; clear; lia.
have hm : t j.+1 < t m.
  rewrite lt_neqAle tle // andbT; apply/eqP => e; have U : t 0%N < t m by rewrite -e.
  move: hk; rewrite e (mult_tm t_mono U) (last_span_uniq t_mono U _ h e); last by move: jn; clear; lia.
  by move: jn; clear; lia.
have [p [p1 p2 p3 p4]] := mult_span_eq t_mono (introT andP (conj h0 hm)); set q := mult _ _ _ in hk p2 p3 p4 *.
have pj : (p <= j)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono).
have jq : (j < p + q)%N.
  have : (j.+1 < (p + q).+1)%N by apply: (t_lt_ltn t_mono).
  by rewrite ltnS.
suff e : p = j by move: p3; rewrite e addSn.
apply/eqP; rewrite eqn_leq pj /= leqNgt; apply/negP => lt.
by move: h; rewrite (p2 j) ?ltxx // lt ltnW.
Qed.
Lemma copies_left j : (k <= j <= n)%N -> t j < t j.+1 -> (mult t m (t j) < k)%N -> t (j - mult t m (t j))%N < t j.
Proof.
move=> /andP[kj jn] h hk.
have h0 : t 0%N < t j.
  rewrite lt_neqAle tle // andbT; apply/eqP => e; move: hk; rewrite ltnNge => /negP; apply.
  apply: (@leq_trans j.+1); first exact: leqW.
  rewrite /mult; have -> : (m.+1 = j.+1 + (m - j))%N by move: jn; clear; lia.
  rewrite iotaD count_cat (@eq_in_count _ _ predT (iota 0 _)); first by rewrite count_predT size_iota leq_addr.
  move=> l; rewrite mem_iota => /andP[_ hl] /=; apply/eqP/eqP; rewrite eq_le tle //= -e; exact: tle.
have hm : t j < t m by apply: lt_le_trans h _; apply: tle; move: jn; clear; lia.
have [p [p1 p2 p3 p4]] := mult_span_eq t_mono (introT andP (conj h0 hm)); set q := mult _ _ _ in hk p2 p3 p4 *.
have pj : (p < j)%N by apply: (t_lt_ltn t_mono).
have jq : (j <= p + q)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono).
have -> : (j - q = p)%N; last exact: p1.
suff : (p + q <= j)%N by move: jq; clear; lia.
rewrite leqNgt; apply/negP => lt; move: h; rewrite (p2 j.+1) ?ltxx //; move: pj lt; clear; lia.
Qed.
(* X.limit.trace: both bounds *)
Theorem X_limit_trace_printed j p x : (1 <= k)%N -> (k <= j <= n)%N -> (1 <= p <= k)%N -> t j <= x < t j.+1 ->
  (p = minn (mult t m (t j.+1)) k -> 1 - \sum_(j - k <= i < (j - k + p).+1) value k i x <=
     r * \sum_(p.+1 <= q < k.+1) ((t j.+1 - t (j.+1 + p - q)%N) / (t (j.+1 + p)%N - t j.+1))) /\
  (p = minn (mult t m (t j)) k -> 1 - \sum_(j - p <= i < j.+1) value k i x <=
     r^-1 * \sum_(p.+1 <= q < k.+1) ((t (j - p + q)%N - t j) / (t j - t (j - p)%N))).
Proof.
move=> k1 hj /andP[p1 pk] hx; have /andP[x1 x2] := hx; have /andP[kj jn] := hj; have ss := le_lt_trans x1 x2.
have hx' : t j <= x <= t j.+1 by rewrite x1 ltW.
have w01 e l : (l <= j < l + e)%N -> 0 <= mw r t e l x <= 1 by exact: (span_01 t_mono ss r0 hx').
have jm : (j < m)%N by move: jn; clear; lia.
have S a b : (a <= b)%N -> \sum_(a <= i < b) value k i x = TT t j r k a x - TT t j r k b x.
  move=> ab; rewrite -[RHS]opprB -telescope_sumr // -sumrN; apply: eq_big_nat => i /andP[_ ib].
  by rewrite opprB value_in ?(lt_le_trans x2 (tle jm)) // (G_P r t_mono _ _ hx) /P /piece N_T.
split=> ep.
  rewrite S; last by clear; lia.
  rewrite {1}/TT T_low; last by move: kj; clear; lia.
  rewrite opprB addrC subrK; move: pk; rewrite leq_eqVlt => /orP[/eqP pk|pk].
    by rewrite pk /TT T_high ?big_geq ?mulr0 //; move: kj; clear; lia.
  have mu : mult t m (t j.+1) = p by move: ep pk; clear; lia.
  have lt : t j.+1 < t (j.+1 + p)%N by have := copies_right hj ss; rewrite mu => /(_ pk).
  have -> : ((j - k + p).+1 = j - (k - p.+1))%N by move: kj pk; clear; lia.
  have c1 : (k - p.+1 < k)%N by move: k1; clear; lia.
  have c2 : (k - p.+1 <= j)%N by move: kj; clear; lia.
  have H := @T_down R (fun e l => mw r t e l x) j w01 k (k - p.+1) c1 c2; rewrite /TT.
  apply: (le_trans H); rewrite mulr_sumr -[p.+1]add0n big_addn.
  have -> : (k.+1 - p.+1 = (k - p.+1).+1)%N by move: pk; clear; lia.
  rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => e /andP[/andP[_ he] _].
  have -> : (k - (k - p.+1) + e = e + p.+1)%N by move: pk; clear; lia.
  have -> : (j.+1 + p - (e + p.+1) = j - e)%N by clear; lia.
  have E : (j - e + (e + p.+1) = j.+1 + p)%N by move: he kj pk; clear; lia.
  have a0 : 0 <= x - t (j - e)%N by rewrite subr_ge0 (le_trans (tle (leq_subr e j))).
  have a1 : x - t (j - e)%N <= t j.+1 - t (j - e)%N by rewrite ler_add2r ltW.
  have b1 : t (j.+1 + p)%N - t j.+1 <= t (j.+1 + p)%N - x by rewrite ler_add2l ler_opp2 ltW.
  have b0 : 0 < t (j.+1 + p)%N - t j.+1 by rewrite subr_gt0.
  rewrite /mw E /mob mulrA; have b2 := lt_le_trans b0 b1; have ra := mulr_ge0 (ltW r0) a0.
  apply: ler_pmul => //; first by rewrite invr_ge0 addr_ge0 // ltW.
    by rewrite ler_pmul2l.
  by rewrite lef_pinv ?posrE ?(ltr_paddl ra) //; apply: (le_trans b1); rewrite ler_addr.
rewrite S; last by move: kj; clear; lia.
rewrite [TT t j r k j.+1 x]/TT T_high // subr0; move: pk; rewrite leq_eqVlt => /orP[/eqP pk|pk].
  by rewrite pk /TT T_low ?subrr ?big_geq ?mulr0 //; move: kj; clear; lia.
have mu : mult t m (t j) = p by move: ep pk; clear; lia.
have lt : t (j - p)%N < t j by have := copies_left hj ss; rewrite mu => /(_ pk).
have e0 : (j - p + p = j)%N by move: kj pk; clear; lia.
have := @T_up R (fun e l => mw r t e l x) j w01 (j - p) p (k - p) e0; have -> : (p + (k - p) = k)%N by move: pk; clear; lia.
rewrite /TT => H; apply: (le_trans H); rewrite mulr_sumr -[p.+1]add0n big_addn subSS.
rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => e /andP[/andP[_ he] _].
have -> : ((p + e).+1 = e + p.+1)%N by clear; lia.
have xe : x <= t (j - p + (e + p.+1))%N by apply: le_trans (ltW x2) _; apply: tle; move: e0; clear; lia.
have a0 : 0 < x - t (j - p)%N by rewrite subr_gt0 (lt_le_trans lt).
have a1 : t j - t (j - p)%N <= x - t (j - p)%N by rewrite ler_add2r.
have a2 : 0 < t j - t (j - p)%N by rewrite subr_gt0.
rewrite /mw mob_compl //; [|by rewrite -subr_ge0 ltW|by apply: lt_le_trans xe; rewrite -subr_gt0].
have b0 : 0 <= t (j - p + (e + p.+1))%N - x by rewrite subr_ge0.
have b1 : t (j - p + (e + p.+1))%N - x <= t (j - p + (e + p.+1))%N - t j by rewrite ler_add2l ler_opp2.
have ra : 0 < r * (x - t (j - p)%N) by rewrite mulr_gt0.
have -> : forall u v : R, r^-1 * (u / v) = u / (r * v) by move=> u v; rewrite invfM mulrCA.
apply: ler_pmul => //; first by rewrite invr_ge0 addr_ge0 // ltW.
have q0 : 0 < r * (t j - t (j - p)%N) by rewrite mulr_gt0.
have q1 : r * (t j - t (j - p)%N) <= r * (x - t (j - p)%N) + (t (j - p + (e + p.+1))%N - x).
  by apply: (@le_trans _ _ (r * (x - t (j - p)%N))); [rewrite ler_pmul2l|rewrite ler_addl].
by rewrite lef_pinv ?posrE // (lt_le_trans q0).
Qed.
End Trace.

(* ---- the arcs ---- *)
Section Arc.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Local Notation value := (value r t m).
(* de Boor's algorithm on the last and on the first span with the knots beyond it moved into its end; on these spans G[i,0] is [i = n], [i = k] *)
Definition rise i x : R := r * (t m - t i) / (t m - x + r * (t m - t i)).
Fixpoint last i q x : R := if q is e.+1 then rise i x * last i e x + (1 - rise i.+1 x) * last i.+1 e x else value 0 i x.
Definition fall i x : R := (t i - t 0%N) / (r * (x - t 0%N) + (t i - t 0%N)).
Fixpoint first i q x : R := if q is e.+1 then (1 - fall (i + q)%N x) * first i e x + fall (i + q).+1 x * first i.+1 e x else value 0 i x.

Lemma T_ext (w w' : nat -> nat -> R) s d i : (forall e j, (j <= s < j + e)%N -> (e <= d)%N -> w e j = w' e j) -> T w s d i = T w' s d i.
Proof.
elim: d i => [|d IH] i h //; case: (leqP i s) => is_; last by rewrite !T_high.
case: (ltnP s (i + d.+1)) => sd; last by rewrite !T_low.
by rewrite !TS !IH ?h ?is_ // => e j hj he; apply: h => //; exact: leqW.
Qed.
Lemma arc_sum s b (w w' : nat -> nat -> R) (f : nat -> R) D x a : (s < b)%N -> (b <= n.+1)%N -> t s <= x < t s.+1 -> 0 <= D ->
  (forall e j, (j <= s < j + e)%N -> (e <= k)%N -> mw r t e j x = w e j) -> (forall i, (i < b)%N -> f i = N w' s k i) ->
  (forall e j, (j <= s < j + e)%N -> 0 <= w e j <= 1) -> (forall e j, (j <= s < j + e)%N -> 0 <= w' e j <= 1) ->
  (forall e j, (j <= s < j + e)%N -> `|w' e j - w e j| <= D) ->
  (forall e j, (j <= s < j + e)%N -> (j.+1 <= s < j.+1 + e)%N -> w' e j.+1 <= w' e j) ->
  \sum_(a <= i < s.+1) `|\sum_(i <= j < b) (value k j x - f j)| <= k%:R * D.
Proof.
move=> sb bn hx D0 ew ef w01 w01' hD hf.
have sm : (s < m)%N by move: sb bn; clear; lia.
have H := @T_distance R w w' s D D0 w01 w01' hD hf k s.+1 (ltnSn s).
apply: le_trans H; case: (leqP a s.+1) => ha; last first.
  by rewrite big_geq ?sumr_ge0 // ltnW.
rewrite [X in _ <= X](big_cat_nat _ (n := a)) //= -[X in X <= _]add0r ler_add ?sumr_ge0 //.
rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[/andP[_ hi] _].
have ib : (i <= b)%N by move: hi sb; clear; lia.
rewrite sumrB (@sum_TT R t t_mono n k r s x i b sm hx sb ib) (eq_big_nat _ _ (F2 := fun j => N w' s k j)); last by move=> j /andP[_ hj]; rewrite ef.
by rewrite (T_sum w' k sb ib) /TT (T_ext i ew) -normrN opprB.
Qed.
(* X.limit.arc: both bounds *)
Theorem X_limit_arc_printed : (1 <= k)%N -> Uclamped t n k ->
  (forall x, t n <= x < t m -> \sum_(n - k + 1 <= i < n.+1) `|\sum_(i <= j < n.+1) (value k j x - last j k x)| <= k%:R * r) /\
  (forall x, t 0%N < x < t k.+1 -> \sum_(1 <= i < k.+1) `|\sum_(i <= j < k.+1) (value k j x - first j k x)| <= k%:R / r).
Proof.
move=> k1 [[e0 e1 e2] h1 h2]; have kn := Uopen_kn t_mono e2.
split=> x /andP[x1 x2].
  have xn : t n <= x < t n.+1 by rewrite x1 e1.
  have v0 : 0 < t m - x by rewrite subr_gt0.
  have c0 j : (j <= n)%N -> 0 <= x - t j by move=> hj; rewrite subr_ge0 (le_trans (tle hj)).
  have c1 j : (j <= n)%N -> 0 < t m - t j by move=> hj; rewrite subr_gt0 (le_lt_trans (tle hj)) // (le_lt_trans x1).
  have d0 j : (j <= n)%N -> 0 < t m - x + r * (t m - t j) by move=> hj; rewrite addr_gt0 // mulr_gt0 // c1.
  apply: (@arc_sum n n.+1 (fun e j => mob r x (t j) (t m)) (fun e j => rise j x)) => //; rewrite ?(ltW r0) //.
  - move=> e j hj he; rewrite /mw; congr (mob _ _ _ _); apply/eqP; rewrite eq_le tle /=; last by move: hj he; clear; lia.
    by rewrite -e1 tle //; case/andP: hj.
  - move=> i _; elim: k i => [|d IH] i; last by rewrite /= !IH.
    by rewrite /= value_in // G0 (span_eq t_mono i xn); case: (i == n).
  - move=> e j /andP[hj _]; apply: mob_01 => //; [by rewrite -subr_ge0 c0|exact: ltW|by rewrite -subr_gt0 c1].
  - move=> e j /andP[hj _]; rewrite /rise divr_ge0 ?mulr_ge0 ?(ltW r0) ?(ltW (c1 j hj)) ?(ltW (d0 j hj)) //=.
    by rewrite ler_pdivr_mulr ?d0 // mul1r ler_addr ltW.
  - move=> e j /andP[hj _]; have u0 := c0 j hj; have D1 := d0 j hj; have ru := mulr_ge0 (ltW r0) u0.
    have D2 : 0 < r * (x - t j) + (t m - x) by rewrite ltr_paddl.
    have -> : rise j x - mob r x (t j) (t m) = r * ((t m - x) / (t m - x + r * (t m - t j)) * ((t m - x) / (r * (x - t j) + (t m - x)))).
      have n1 : t m - x + r * (t m - t j) != 0 by rewrite gt_eqF. have n2 : r * (x - t j) + (t m - x) != 0 by rewrite gt_eqF.
      by rewrite /rise /mob; move: (t m) (t j) n1 n2 => p q n1 n2; field; rewrite n1 n2.
    have p1 : 0 <= (t m - x) / (t m - x + r * (t m - t j)) <= 1.
      by rewrite divr_ge0 ?(ltW v0) ?(ltW D1) //= ler_pdivr_mulr // mul1r ler_addl mulr_ge0 ?(ltW r0) // ltW // c1.
    have p2 : 0 <= (t m - x) / (r * (x - t j) + (t m - x)) <= 1.
      by rewrite divr_ge0 ?(ltW v0) ?(ltW D2) //= ler_pdivr_mulr // mul1r ler_addr.
    move: (_ / _) (_ / (r * _ + _)) p1 p2 => p q /andP[p0 p1] /andP[q0 q1].
    by rewrite ger0_norm ?mulr_ge0 ?(ltW r0) // -[X in _ <= X]mulr1 ler_wpmul2l ?(ltW r0) // -[X in _ <= X]mul1r ler_pmul.
  move=> e j _ /andP[hj _]; have hj' := ltnW hj; rewrite /rise ler_pdivr_mulr ?d0 // mulrAC ler_pdivl_mulr ?d0 // -subr_ge0.
  have -> : r * (t m - t j) * (t m - x + r * (t m - t j.+1)) - r * (t m - t j.+1) * (t m - x + r * (t m - t j)) = r * ((t m - x) * (t j.+1 - t j)).
    by move: (t m) (t j) (t j.+1) => p q u; ring.
  by rewrite !mulr_ge0 ?(ltW r0) ?(ltW v0) // subr_ge0.
have tk j : (j <= k)%N -> t j = t 0%N by move=> hj; apply/eqP; rewrite eq_le {1}e0 !tle.
have xk : t k <= x < t k.+1 by rewrite x2 tk // ltW.
have u0 : 0 < x - t 0%N by rewrite subr_gt0. have ru : 0 < r * (x - t 0%N) by rewrite mulr_gt0.
have c0 j : (k < j)%N -> 0 < t j - x by move=> hj; rewrite subr_gt0 (lt_le_trans x2) // tle.
have c1 j : (k < j)%N -> 0 < t j - t 0%N by move=> hj; rewrite subr_gt0 (lt_trans x1) // -subr_gt0 c0.
have d0 j : (k < j)%N -> 0 < r * (x - t 0%N) + (t j - t 0%N) by move=> hj; rewrite addr_gt0 // c1.
have f01 j : (k < j)%N -> 0 <= fall j x <= 1.
  by move=> hj; rewrite /fall divr_ge0 ?(ltW (c1 j hj)) ?(ltW (d0 j hj)) //= ler_pdivr_mulr ?d0 // mul1r ler_addr ltW.
apply: (@arc_sum k k.+1 (fun e j => mw r t e j x) (fun e j => 1 - fall (j + e)%N x)) => //; rewrite ?invr_ge0 ?(ltW r0) //.
- move=> i _; elim: {1 3}k i => [|d IH] i.
    rewrite /= value_in; last by apply: (lt_le_trans x2); apply: tle; clear; lia.
    by rewrite G0 (span_eq t_mono i xk); case: (i == k).
  have E : 1 - (1 - fall (i.+1 + d.+1)%N x) = fall (i + d.+1).+1 x by rewrite opprB addrC subrK addSn.
  by rewrite NS -!IH E.
- move=> e j hj; have ss : t k < t k.+1 := h1; apply: (span_01 t_mono ss r0 _ hj); by case/andP: xk => -> /ltW ->.
- by move=> e j /andP[_ hj]; have /andP[a b] := f01 _ hj; rewrite subr_ge0 b ler_subl_addl ler_addr.
- move=> e j /andP[hj hj']; have v0 := c0 _ hj'; have cc := c1 _ hj'; have D1 := d0 _ hj'.
  have D2 : 0 < r * (x - t 0%N) + (t (j + e)%N - x) by rewrite addr_gt0.
  rewrite /mw (tk j hj) /fall /mob; move: (t (j + e)%N) (t 0%N) u0 ru v0 cc D1 D2 => p q u0 ru v0 cc D1 D2.
  have -> : 1 - (p - q) / (r * (x - q) + (p - q)) - r * (x - q) / (r * (x - q) + (p - x)) =
      - ((r * (x - q)) / (r * (x - q) + (p - q)) * ((x - q) / (r * (x - q) + (p - x)))).
    have n1 : r * (x - q) + (p - q) != 0 by rewrite gt_eqF. have n2 : r * (x - q) + (p - x) != 0 by rewrite gt_eqF.
    by field; rewrite n1 n2.
  have p1 : 0 <= (r * (x - q)) / (r * (x - q) + (p - q)) <= 1.
    by rewrite divr_ge0 ?(ltW ru) ?(ltW D1) //= ler_pdivr_mulr // mul1r ler_addl ltW.
  have p2 : 0 <= (x - q) / (r * (x - q) + (p - x)) <= r^-1.
    rewrite divr_ge0 ?(ltW u0) ?(ltW D2) //= ler_pdivr_mulr // mulrDr mulKf ?gt_eqF // ler_addl mulr_ge0 ?invr_ge0 ?(ltW r0) // ltW //.
  move: (r * (x - q) / _) ((x - q) / _) p1 p2 => a b /andP[p0 p1] /andP[q0 q1].
  by rewrite normrN ger0_norm ?mulr_ge0 // -[X in _ <= X]mul1r ler_pmul.
move=> e j /andP[_ hj] /andP[_ hj']; rewrite ler_add2l ler_opp2 /fall addSn.
have hj1 : (k < (j + e).+1)%N by exact: leqW.
rewrite ler_pdivr_mulr ?d0 // mulrAC ler_pdivl_mulr ?d0 // -subr_ge0.
have -> : (t (j + e).+1 - t 0%N) * (r * (x - t 0%N) + (t (j + e)%N - t 0%N)) - (t (j + e)%N - t 0%N) * (r * (x - t 0%N) + (t (j + e).+1 - t 0%N)) =
  r * (x - t 0%N) * (t (j + e).+1 - t (j + e)%N) by move: (t _) (t _) (t _) => p q u; ring.
by rewrite mulr_ge0 ?(ltW ru) // subr_ge0.
Qed.
End Arc.
