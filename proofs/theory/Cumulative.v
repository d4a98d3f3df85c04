(* The cumulative functions T_i = G_i + G_(i+1) + ..: how they move with x and with alpha, and what follows for curves (X.order, X.close).
   On a span T_i^d = w_i^d T_i^(d-1) + (1 - w_i^d) T_(i+1)^(d-1), so that greater weights make greater T. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis StatementsDerivatives StatementsCurves.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Algebra.
Variable R : comRingType.
Implicit Type w : nat -> nat -> R.
Fixpoint T w (s d i : nat) : R := if d is e.+1 then w d i * T w s e i + (1 - w d i) * T w s e i.+1 else (i <= s)%N%:R.
Lemma TS w s d i : T w s d.+1 i = w d.+1 i * T w s d i + (1 - w d.+1 i) * T w s d i.+1. Proof. by []. Qed.
(* a function is a difference of two cumulative ones *)
Theorem N_T w s d i : N w s d i = T w s d i - T w s d i.+1.
Proof.
elim: d i => [|d IH] i; last by rewrite NS !IH !TS; ring.
by rewrite /=; case: (ltngtP i s) => h; rewrite ?subrr ?subr0.
Qed.
Lemma T_low w s d i : (i + d <= s)%N -> T w s d i = 1.
Proof.
elim: d i => [|d IH] i h; first by rewrite /= -[i]addn0 h.
rewrite TS !IH; [ring|by rewrite addSnnS|by apply: leq_trans h; rewrite leq_add2l].
Qed.
Lemma T_high w s d i : (s < i)%N -> T w s d i = 0.
Proof.
elim: d i => [|d IH] i h; first by rewrite /= leqNgt h.
by rewrite TS !IH ?mulr0 ?addr0 // ltnW.
Qed.
Lemma T_sum w s d i b : (s < b)%N -> (i <= b)%N -> \sum_(i <= j < b) N w s d j = T w s d i.
Proof.
move=> sb ib; rewrite (eq_bigr (fun j => - (T w s d j.+1 - T w s d j))); last by move=> j _; rewrite N_T opprB.
by rewrite sumrN telescope_sumr // (T_high _ _ sb) sub0r opprK.
Qed.
End Algebra.

Section Order.
Variable R : realFieldType.
Variables (w w' : nat -> nat -> R) (s : nat).
Local Notation inside d i := (i <= s < i + d)%N.
Lemma N_gt0 d i : (forall e j, inside e j -> 0 < w e j < 1) -> (i <= s <= i + d)%N -> 0 < N w s d i.
Proof.
move=> h; elim: d i => [|d IH] i hi.
  have -> : i = s by move: hi; clear; lia.
  by rewrite /= eqxx ltr01.
rewrite NS; case: (boolP (i <= s <= i + d)%N) => e.
  have /andP[a _] := h d.+1 i ltac:(move: e; clear; lia).
  apply: ltr_paddr; last by rewrite mulr_gt0 // IH.
  case: (boolP (i.+1 <= s <= i.+1 + d)%N) => e'; last by rewrite N_supp ?mulr0.
  have /andP[_ b] := h d.+1 i.+1 ltac:(move: e'; clear; lia).
  by apply: mulr_ge0; [rewrite subr_ge0 ltW|rewrite ltW // IH].
rewrite N_supp // mulr0 add0r.
have e' : (i.+1 <= s <= i.+1 + d)%N by move: e hi; clear; lia.
have /andP[_ b] := h d.+1 i.+1 ltac:(move: e'; clear; lia).
by rewrite mulr_gt0 ?subr_gt0 // IH.
Qed.
Lemma N_ge0 d i : (forall e j, inside e j -> 0 <= w e j <= 1) -> 0 <= N w s d i.
Proof.
move=> h; elim: d i => [|d IH] i; first by rewrite /= ler0n.
rewrite NS addr_ge0 //.
  case: (boolP (i <= s <= i + d)%N) => e; last by rewrite N_supp ?mulr0.
  have /andP[a _] := h d.+1 i ltac:(move: e; clear; lia).
  by rewrite mulr_ge0.
case: (boolP (i.+1 <= s <= i.+1 + d)%N) => e; last by rewrite N_supp ?mulr0.
have /andP[_ b] := h d.+1 i.+1 ltac:(move: e; clear; lia).
by rewrite mulr_ge0 // subr_ge0.
Qed.
Lemma T_diff d i : T w' s d.+1 i - T w s d.+1 i =
  w' d.+1 i * (T w' s d i - T w s d i) + (1 - w' d.+1 i) * (T w' s d i.+1 - T w s d i.+1) + (w' d.+1 i - w d.+1 i) * N w s d i.
Proof. by rewrite !TS N_T; ring. Qed.
Lemma T_01 d i : (forall e j, inside e j -> 0 <= w e j <= 1) -> 0 <= T w s d i <= 1.
Proof.
move=> h; elim: d i => [|d IH] i; first by rewrite /= ler0n lern1 leq_b1.
case: (boolP (inside d.+1 i)) => hi; last first.
  case: (ltnP s i) => si; first by rewrite T_high // lexx ler01.
  by rewrite T_low ?ler01 ?lexx //; move: hi si; clear; lia.
have /andP[a b] := h _ _ hi; have /andP[p q] := IH i; have /andP[p' q'] := IH i.+1.
rewrite TS addr_ge0 ?mulr_ge0 ?subr_ge0 //=.
rewrite -subr_ge0; move: (w d.+1 i) (T w s d i) (T w s d i.+1) a b p q p' q' => u v v' a b p q p' q'.
have -> : 1 - (u * v + (1 - u) * v') = u * (1 - v) + (1 - u) * (1 - v') by ring.
by rewrite addr_ge0 // mulr_ge0 ?subr_ge0.
Qed.
(* greater weights, greater T *)
Theorem T_le d i : (forall e j, inside e j -> 0 <= w e j <= 1) -> (forall e j, inside e j -> 0 <= w' e j <= 1) ->
  (forall e j, inside e j -> (e <= d)%N -> w e j <= w' e j) -> T w s d i <= T w' s d i.
Proof.
move=> h h'; elim: d i => [|d IH] i hw; first exact: lexx.
have IH' j : T w s d j <= T w' s d j by apply: IH => e l hl he; apply: hw => //; apply: leqW.
case: (boolP (inside d.+1 i)) => hi; last first.
  case: (ltnP s i) => si; first by rewrite !T_high.
  by rewrite !T_low //; move: hi si; clear; lia.
have /andP[a b] := h' _ _ hi.
rewrite -subr_ge0 T_diff; apply: addr_ge0; first apply: addr_ge0.
- by rewrite mulr_ge0 // subr_ge0.
- by rewrite mulr_ge0 // subr_ge0.
by rewrite mulr_ge0 ?N_ge0 // subr_ge0 hw.
Qed.
(* greater weights, greater T, strictly *)
Theorem T_lt d i : (forall e j, inside e j -> 0 < w e j < 1) -> (forall e j, inside e j -> 0 <= w' e j <= 1) ->
  (forall e j, inside e j -> (e <= d)%N -> w e j < w' e j) -> (i <= s < i + d)%N -> T w s d i < T w' s d i.
Proof.
move=> h h' hw hi; case: d hw hi => [|d] hw hi; first by move: hi; clear; lia.
have hl e j : inside e j -> 0 <= w e j <= 1 by move=> hj; have /andP[a b] := h _ _ hj; rewrite !ltW.
have IH' j : T w s d j <= T w' s d j by apply: T_le => // e l hl1 he; apply: ltW; apply: hw => //; apply: leqW.
have /andP[a b] := h' _ _ hi.
rewrite -subr_gt0 T_diff; apply: ltr_paddl; first by rewrite addr_ge0 // mulr_ge0 ?subr_ge0.
by rewrite mulr_gt0 ?subr_gt0 ?hw // N_gt0 //; move: hi; clear; lia.
Qed.
End Order.

(* ---- the paper's weight ---- *)
Section Weight.
Variable R : realFieldType.
(* it rises with r and with x *)
Lemma mob_r (r r' x a b : R) : 0 < r -> r < r' -> a < x -> x < b -> mob r x a b < mob r' x a b.
Proof.
move=> r0 rr ax xb; have r0' := lt_trans r0 rr; have ab := lt_trans ax xb.
have d1 := mob_den_gt0 r0 (ltW ax) (ltW xb) ab; have d2 := mob_den_gt0 r0' (ltW ax) (ltW xb) ab.
rewrite /mob ltr_pdivr_mulr // mulrAC ltr_pdivl_mulr // -subr_gt0.
have -> : r' * (x - a) * (r * (x - a) + (b - x)) - r * (x - a) * (r' * (x - a) + (b - x)) = (r' - r) * ((x - a) * (b - x)) by ring.
by rewrite !mulr_gt0 ?subr_gt0.
Qed.
Lemma mob_x (r x y a b : R) : 0 < r -> a <= x -> x <= y -> y <= b -> a < b -> mob r x a b <= mob r y a b.
Proof.
move=> r0 ax xy yb ab; have d1 := mob_den_gt0 r0 ax (le_trans xy yb) ab; have d2 := mob_den_gt0 r0 (le_trans ax xy) yb ab.
rewrite /mob ler_pdivr_mulr // mulrAC ler_pdivl_mulr // -subr_ge0.
have -> : r * (y - a) * (r * (x - a) + (b - x)) - r * (x - a) * (r * (y - a) + (b - y)) = r * ((y - x) * (b - a)) by ring.
by rewrite !mulr_ge0 ?subr_ge0 // ltW.
Qed.
Lemma mob_01 (r x a b : R) : 0 < r -> a <= x -> x <= b -> a < b -> 0 <= mob r x a b <= 1.
Proof.
move=> r0 ax xb ab; rewrite mob_ge0 //= -subr_ge0 mob_compl //.
by rewrite divr_ge0 ?subr_ge0 // ltW // mob_den_gt0.
Qed.
End Weight.

Section Paper.
Variable R : realFieldType.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Section Span.
Variable s : nat.
Hypothesis ss : t s < t s.+1.
Lemma span_ab e j : (j <= s < j + e)%N -> t j < t (j + e)%N.
Proof. by move=> /andP[a b]; apply: (le_lt_trans (tle a)); apply: (lt_le_trans ss); apply: tle. Qed.
Lemma span_01 r x e j : 0 < r -> t s <= x <= t s.+1 -> (j <= s < j + e)%N -> 0 <= mw r t e j x <= 1.
Proof.
move=> r0 /andP[x1 x2] hj; have /andP[a b] := hj; apply: mob_01 => //; last exact: span_ab.
  exact: le_trans (tle a) x1.
exact: le_trans x2 (tle b).
Qed.
Lemma span_in r x e j : 0 < r -> t s < x < t s.+1 -> (j <= s < j + e)%N -> 0 < mw r t e j x < 1.
Proof.
move=> r0 /andP[x1 x2] hj; have /andP[a b] := hj.
have p1 : t j < x by apply: le_lt_trans (tle a) x1. have p2 : x < t (j + e)%N by apply: lt_le_trans x2 (tle b).
by rewrite /mw mob_gt0 ?mob_lt1 // ltW.
Qed.
Definition TT r d i x := T (fun e j => mw r t e j x) s d i.
(* T_i is a non-decreasing function of x *)
Theorem TT_x r d i x y : 0 < r -> t s <= x -> x <= y -> y <= t s.+1 -> TT r d i x <= TT r d i y.
Proof.
move=> r0 sx xy ys; apply: T_le.
- by move=> e j; apply: span_01; rewrite ?sx ?(le_trans xy).
- by move=> e j; apply: span_01; rewrite ?ys ?(le_trans sx).
move=> e j hj _; have /andP[a b] := hj; apply: mob_x => //; last exact: span_ab.
  exact: le_trans (tle a) sx.
exact: le_trans ys (tle b).
Qed.
(* T_i rises strictly with r inside of the span, for s-d < i <= s *)
Theorem TT_r r r' d i x : 0 < r -> r < r' -> t s < x < t s.+1 -> (i <= s < i + d)%N -> TT r d i x < TT r' d i x.
Proof.
move=> r0 rr hx hi; have r0' := lt_trans r0 rr; apply: T_lt => //.
- by move=> e j; apply: span_in.
- by move=> e j hj; have /andP[a b] := span_in r0' hx hj; rewrite !ltW.
move=> e j hj _; have /andP[a b] := hj; have /andP[x1 x2] := hx; apply: mob_r => //.
  exact: le_lt_trans (tle a) x1.
exact: lt_le_trans x2 (tle b).
Qed.
End Span.

Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Lemma sum_TT r s x a b : (s < m)%N -> t s <= x < t s.+1 -> (s < b)%N -> (a <= b)%N -> \sum_(a <= i < b) value r t m k i x = TT s r k a x.
Proof.
move=> sm hx sb ab; rewrite /TT -(T_sum (fun e j => mw r t e j x) k sb ab); apply: eq_bigr => i _.
rewrite value_in; first by rewrite (G_P r t_mono _ _ hx).
by case/andP: hx => _ h; apply: (lt_le_trans h); apply: tle.
Qed.
(* X.order: inside of a span G_0 + .. + G_j falls strictly as r rises, l-k <= j < l *)
Theorem X_order_printed r r' l j x : (1 <= k)%N -> 0 < r -> r < r' -> (k <= l <= n)%N -> (l - k <= j < l)%N -> t l < x < t l.+1 ->
  \sum_(0 <= i < j.+1) value r' t m k i x < \sum_(0 <= i < j.+1) value r t m k i x.
Proof.
move=> k1 r0 rr hl hj hx; have r0' := lt_trans r0 rr.
have lm : (l < m)%N by move: hl; clear; lia.
have hx' : t l <= x < t l.+1 by have /andP[a b] := hx; rewrite ltW.
have ss : t l < t l.+1 by have /andP[a b] := hx; apply: lt_trans b.
have S q : \sum_(0 <= i < j.+1) value q t m k i x = 1 - TT l q k j.+1 x.
  have jn : (j.+1 <= n.+1)%N by move: hl hj; clear; lia.
  have := @sum_TT q l x 0 n.+1 lm hx'; rewrite (big_cat_nat _ (n := j.+1)) //=.
  rewrite (@sum_TT q l x j.+1 n.+1) //; last by move: hl; clear; lia.
  have ln : (l < n.+1)%N by move: hl; clear; lia.
  move=> /(_ ln isT) e.
  have one : TT l q k 0 x = 1.
    rewrite -(@sum_TT q l x 0 n.+1) //.
    have [_ <-] := @T3_5_3_amended R q t t_mono n k l x hl hx'.
    by [].
  by rewrite one in e; rewrite -e addrK.
rewrite !S ltr_add2l ltr_opp2; apply: TT_r => //.
by move: hj; clear; lia.
Qed.

(* ---- T_i as a function on [t_0, t_m]: non-decreasing, whatever the knots ---- *)
Lemma TT_knot r d i p q : 0 < r -> t p < t p.+1 -> (forall j, (p < j <= p + q)%N -> t j = t p.+1) -> t p.+1 < t (p + q).+1 ->
  TT p r d i (t p.+1) <= TT (p + q) r d i (t p.+1).
Proof.
move=> r0 h1 h2 h3.
have s2 : t (p + q)%N < t (p + q).+1.
  by case: (posnP q) => [e|q0]; [move: h3; rewrite e addn0 ltxx|rewrite h2 // -addn1 leq_add2l q0 leqnn].
have i1 : t p <= t p.+1 <= t p.+1 by rewrite lexx ltW.
have i2 : t (p + q)%N <= t p.+1 <= t (p + q).+1.
  by rewrite (ltW h3) andbT; case: (posnP q) => [e|q0]; [rewrite e addn0 ltW|rewrite h2 // -addn1 leq_add2l q0 leqnn].
have /andP[a b] := @T_01 R (fun e j => mw r t e j (t p.+1)) p d i (fun e j => @span_01 p h1 r _ e j r0 i1).
have /andP[a' b'] := @T_01 R (fun e j => mw r t e j (t p.+1)) (p + q) d i (fun e j => @span_01 (p + q) s2 r _ e j r0 i2).
case: (leqP d q) => dq.
  case: (ltnP p i) => pi; first by rewrite {1}/TT T_high.
  by rewrite {2}/TT T_low // leq_add.
case: (ltnP (p + q) i) => pi; first by rewrite /TT !T_high //; move: pi; clear; lia.
have pq : (p < (p + q).+1)%N by rewrite ltnS leq_addr.
rewrite /TT -(T_sum (fun e j => mw r t e j (t p.+1)) d (ltnSn (p + q)) (leqW pi)).
rewrite -(T_sum (fun e j => mw r t e j (t p.+1)) d pq (leqW pi)).
rewrite le_eqVlt; apply/orP; left; apply/eqP; apply: eq_bigr => j _.
exact: (@P3_1_2 R (mw r t) t t_mono (@mw_left R r t) (mw_right r0 (t := t)) p q d j (t p.+1) h1 h2 h3 (ltnW dq)).
Qed.
(* X.monotone: every T_i = G_i + … + G_n is non-decreasing, all knots *)
Theorem TT_mono r d i s s' x y : 0 < r -> (s <= s')%N -> t s < t s.+1 -> t s' < t s'.+1 ->
  t s <= x <= t s.+1 -> t s' <= y <= t s'.+1 -> x <= y -> TT s r d i x <= TT s' r d i y.
Proof.
move=> r0; have [a] := ubnP (s' - s)%N; elim: a s x => // a IH s x; rewrite ltnS => la le h h' /andP[x1 x2] hy xy.
have /andP[y1 y2] := hy.
move: le; rewrite leq_eqVlt => /orP[/eqP e|lt].
  by rewrite -e in y2 y1 *; apply: TT_x.
have [s'' [/andP[a1 a2] /andP[b1 b2]]] := @span_exists R t t_mono s.+1 s'.+1 (t s.+1) ltac:(rewrite lexx; exact: (le_lt_trans (tle lt) h')).
apply: (@le_trans _ _ (TT s r d i (t s.+1))); first exact: TT_x.
have E : s'' = (s + (s'' - s))%N by move: a1; clear; lia.
have K j : (s < j <= s + (s'' - s))%N -> t j = t s.+1.
  rewrite -E => /andP[j1 j2]; apply/eqP; rewrite eq_le (le_trans (tle j2) b1) /=; exact: tle.
have b2' : t s.+1 < t (s + (s'' - s)).+1 by rewrite -E.
apply: le_trans (TT_knot d i r0 h K b2') _; rewrite -E.
apply: IH => //.
- by move: la a1 a2; clear; lia.
- by apply: le_lt_trans b1 b2.
- by rewrite b1 ltW.
by apply: le_trans y1; apply: tle.
Qed.

Lemma abel (d F : nat -> R) b : \sum_(0 <= i < b.+1) d i * (F i - F i.+1) =
  d 0%N * F 0%N + \sum_(1 <= i < b.+1) (d i - d i.-1) * F i - d b * F b.+1.
Proof.
elim: b => [|b IH]; first by rewrite big_nat1 big_geq // addr0 mulrBr.
by rewrite big_nat_recr //= IH [in RHS]big_nat_recr //=; move: (\sum_(1 <= i < b.+1) _) => A; ring.
Qed.
(* on a span k <= s <= n the curve is d_0 + the sum of (d_i - d_(i-1)) T_i *)
Lemma C_abel r d s x : (k <= s <= n)%N -> t s <= x < t s.+1 ->
  coordinate r t n k d x = d 0%N + \sum_(1 <= i < n.+1) (d i - d i.-1) * TT s r k i x.
Proof.
move=> /andP[ks sn] hx; rewrite /coordinate (eq_bigr (fun i => d i * (TT s r k i x - TT s r k i.+1 x))); last first.
  move=> i _; rewrite value_in; first by rewrite (G_P r t_mono _ _ hx) /P /piece N_T.
  by case/andP: hx => _ h; apply: (lt_le_trans h); apply: tle; move: sn; clear; lia.
rewrite abel {1}/TT T_low ?add0n // mulr1 [TT s r k n.+1 x]T_high ?mulr0 ?subr0 //; exact: sn.
Qed.
Lemma C_abel_tm r d : Uopen t n k -> 0 < r ->
  coordinate r t n k d (t m) = d 0%N + \sum_(1 <= i < n.+1) (d i - d i.-1) * TT (last_span t m) r k i (t m).
Proof.
move=> ho r0; have U := Uopen_t0 ho; have /andP[ks sn] := last_open t_mono U ho.
rewrite /coordinate (eq_bigr (fun i => d i * (TT (last_span t m) r k i (t m) - TT (last_span t m) r k i.+1 (t m)))); last first.
  by move=> i _; rewrite value_tm /P /piece N_T.
rewrite abel {1}/TT T_low ?add0n // mulr1 [TT _ r k n.+1 _]T_high ?mulr0 ?subr0 //; exact: sn.
Qed.
(* control values that do not fall make a curve that does not fall *)
Theorem monotone_curve r d x y : 0 < r -> Uopen t n k -> (forall i, (i < n)%N -> d i <= d i.+1) ->
  t 0%N <= x -> x <= y -> y <= t m -> coordinate r t n k d x <= coordinate r t n k d y.
Proof.
move=> r0 ho hd x0 xy ym; have U := Uopen_t0 ho; have [e0 e1 e2] := ho.
have at_ z : t 0%N <= z <= t m -> exists s, [/\ (k <= s <= n)%N, t s < t s.+1, t s <= z <= t s.+1,
    coordinate r t n k d z = d 0%N + \sum_(1 <= i < n.+1) (d i - d i.-1) * TT s r k i z & (z < t s.+1) || (s == last_span t m)].
  move=> /andP[z0 zm]; move: zm; rewrite le_eqVlt => /orP[/eqP ->|lt].
    have [p1 p2 p3] := last_spanP t_mono U; have hs := last_open t_mono U ho.
    exists (last_span t m); split => //; last by rewrite eqxx orbT.
      by apply/andP; split; [rewrite -p3; exact: ltW|rewrite p3].
    exact: C_abel_tm.
  have [s [hs /andP[s1 s2]]] : exists s, (k <= s < n.+1)%N /\ t s <= z < t s.+1.
    by apply: span_exists => //; rewrite -e0 z0 e1.
  exists s; split; rewrite ?s2 ?(le_lt_trans s1 s2) ?s1 ?(ltW s2) //.
  by apply: C_abel; rewrite ?s1 ?s2.
have [s [hs ss sx -> fx]] := at_ x ltac:(by rewrite x0 (le_trans xy)).
have [s' [hs' ss' sy -> fy]] := at_ y ltac:(by rewrite ym (le_trans x0)).
rewrite ler_add2l big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[/andP[i1 i2] _].
apply: ler_wpmul2l; first by rewrite subr_ge0; case: i i1 i2 => // i _ i2; apply: hd.
case: (leqP s s') => le; first by apply: TT_mono.
have /andP[x1 x2] := sx; have /andP[y1 y2] := sy.
have ex : x = y.
  apply/eqP; rewrite eq_le xy /=; apply: le_trans x1; apply: le_trans y2 _; exact: tle.
have e : y = t s'.+1 by apply/eqP; rewrite eq_le y2 -ex /=; apply: le_trans x1; exact: tle.
move: fy; rewrite e ltxx /= => /eqP e'; have [p1 p2 p3] := last_spanP t_mono U.
move: ss; rewrite ltNge; case/negP; apply: (@le_trans _ _ (t m)).
  by apply: tle; case/andP: hs => _ hs; move: hs; clear; lia.
by rewrite -p3 -e'; exact: tle.
Qed.
End Paper.
