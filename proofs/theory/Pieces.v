(* One-sided values: the piece of a span, evaluated at the ends of the span.
   P3.1.2 (continuity), T3.5.1 at t_m, P3.1.3 and P4.2.1, for every degree. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Algebra.
Variable R : comRingType.
Implicit Type w : nat -> nat -> R.

(* only weights of intervals that contain the span and lie inside the support matter *)
Lemma N_ext2 w w' s k i :
  (forall d j, (j <= s < j + d)%N -> (i <= j)%N -> (j + d <= i + k)%N \/ (j + d <= i + k.+1)%N -> (d <= k)%N -> w d j = w' d j) ->
  N w s k i = N w' s k i.
Proof.
elim: k i => [|k IH] i h //; rewrite !NS.
have e0 : N w s k i = N w' s k i by apply: IH => d j *; apply: h; lia.
have e1 : N w s k i.+1 = N w' s k i.+1 by apply: IH => d j *; apply: h; lia.
rewrite e0 e1; congr (_ + _).
  case: (boolP (i <= s <= i + k)%N) => e; last by rewrite N_supp // !mulr0.
  by rewrite (h _ i) //; lia.
case: (boolP (i.+1 <= s <= i.+1 + k)%N) => e; last by rewrite N_supp // !mulr0.
by rewrite (h _ i.+1) //; lia.
Qed.

(* at the left side of a knot of multiplicity q: weights of the intervals that end there are 1 *)
Lemma N_left w p q d i : (forall e j, (j <= p)%N -> (p < j + e <= p + q)%N -> w e j = 1) ->
  (d <= q)%N -> N w p d i = (i == p)%:R.
Proof.
move=> h; elim: d i => [|d IH] i dq //; rewrite NS !IH; try lia.
case: (ltngtP i p) => e.
- rewrite mulr0 add0r; case: (eqVneq i.+1 p) => [e2|_]; last by rewrite mulr0.
  by rewrite (h _ i.+1) ?subrr ?mul0r //; lia.
- by rewrite mulr0 add0r; case: (eqVneq i.+1 p) => [|_]; [lia|rewrite mulr0].
- rewrite (h _ i) ?mul1r; try lia; case: (eqVneq i.+1 p) => [|_]; [lia|by rewrite mulr0 addr0].
Qed.
(* at the right side: weights of the intervals that begin there are 0 *)
Lemma N_right w p q d i : (forall e j, (p < j <= p + q)%N -> (p + q < j + e)%N -> w e j = 0) ->
  (d <= q)%N -> (p < i)%N || ((i == p) && (d == q)) -> N w (p + q) d i = (i + d == p + q)%N%:R.
Proof.
move=> h; elim: d i => [|d IH] i dq h2; first by rewrite addn0.
have IH1 : N w (p + q) d i.+1 = (i.+1 + d == p + q)%N%:R by apply: IH; lia.
rewrite NS IH1 addSnnS; case: (boolP (i <= p + q <= i + d)%N) => e.
  have -> : (i + d.+1 == p + q)%N = false by apply/eqP; lia.
  by rewrite mulr0 addr0 (h _ i) ?mul0r //; lia.
rewrite N_supp // mulr0 add0r.
case: (eqVneq (i + d.+1)%N (p + q)%N) => e2; last by rewrite mulr0.
by rewrite (h _ i.+1) ?subr0 ?mul1r //; lia.
Qed.

(* pieces on both sides of a knot of multiplicity q have the same value, if q <= k *)
Theorem N_cont w p q k i :
  (forall e j, (j <= p)%N -> (p < j + e <= p + q)%N -> w e j = 1) ->
  (forall e j, (p < j <= p + q)%N -> (p + q < j + e)%N -> w e j = 0) ->
  (q <= k)%N -> N w p k i = N w (p + q) k i.
Proof.
move=> h1 h0; elim: k i => [|k IH] i qk.
  by rewrite (_ : q = 0%N) ?addn0 //; lia.
case: (leqP q k) => qk'; first by rewrite !NS !IH.
have e : q = k.+1 by lia.
rewrite (@N_left w p q) //.
case: (ltnP i p) => ip; last first.
  rewrite (@N_right w p q) //; try lia.
  by congr (_%:R); lia.
rewrite N_supp; last lia.
by have -> : (i == p) = false by apply/eqP; lia.
Qed.

(* reflection *)
Theorem N_reflect w m s k i : (s < m)%N -> (i + k < m)%N ->
  N w s k i = N (fun d j => 1 - w d (m - d - j)%N) (m - 1 - s) k (m - 1 - k - i).
Proof.
move=> sm; elim: k i => [|k IH] i im.
  by rewrite /=; congr (_%:R); apply/eqP/eqP; lia.
rewrite !NS !IH; try lia.
have -> : (m - 1 - k - i = (m - 1 - k.+1 - i).+1)%N by lia.
have -> : (m - 1 - k - i.+1 = m - 1 - k.+1 - i)%N by lia.
have -> : (m - k.+1 - (m - 1 - k.+1 - i) = i.+1)%N by lia.
have -> : (m - k.+1 - (m - 1 - k.+1 - i).+1 = i)%N by lia.
by rewrite opprB addrC addrCA subrr addr0.
Qed.
End Algebra.

(* ---- pieces for a family of unclipped weights v ---- *)
Section Pieces.
Variable R : realFieldType.
Variables w v : nat -> nat -> R -> R.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Hypothesis w_v : forall d i x, t i <= x < t (i + d)%N -> w d i x = v d i x.
Hypothesis v_left : forall d i, t i < t (i + d)%N -> v d i (t i) = 0.
Hypothesis v_right : forall d i, t i < t (i + d)%N -> v d i (t (i + d)%N) = 1.
Let tle := t_le t_mono.

Definition piece s k i x : R := N (fun d j => v d j x) s k i.

(* on a span G is the piece, with weights that are not cut off *)
Theorem G_piece s k i x : t s <= x < t s.+1 -> G w t k i x = piece s k i x.
Proof.
move=> h; rewrite (G_N t_mono w _ _ h); apply: N_ext => d j /andP[h1 h2] _; apply: w_v.
by case/andP: h => a b; rewrite (le_trans (tle h1) a) (lt_le_trans b (tle h2)).
Qed.

(* P3.1.2: at a knot y of multiplicity q <= k (indices p+1..p+q) the pieces on both sides agree *)
Theorem P3_1_2 p q k i y : t p < y -> (forall j, (p < j <= p + q)%N -> t j = y) -> y < t (p + q).+1 -> (q <= k)%N ->
  piece p k i y = piece (p + q) k i y.
Proof.
move=> py e yq qk; apply: N_cont => // d j h1 h2.
  by rewrite -(e (j + d)%N) // v_right // (e (j + d)%N) // (le_lt_trans (tle h1) py).
by rewrite -(e j) // v_left // (e j) // (lt_le_trans yq (tle h2)).
Qed.
(* so G at y is the limit from the left *)
Corollary P3_1_2_G p q k i y : t p < y -> (forall j, (p < j <= p + q)%N -> t j = y) -> y < t (p + q).+1 -> (q <= k)%N ->
  G w t k i y = piece p k i y.
Proof.
move=> py e yq qk; rewrite (@P3_1_2 p q) //; apply: G_piece; rewrite yq andbT.
case: (posnP q) => q0; last by rewrite e //; lia.
by rewrite q0 addn0 ltW.
Qed.
(* at multiplicity >= k+1 it jumps: G_p is 1 on the left; on the right 0 *)
Theorem P3_1_2_sharp p q k y : t p < y -> (forall j, (p < j <= p + q)%N -> t j = y) -> y < t (p + q).+1 -> (k < q)%N ->
  piece p k p y = 1 /\ piece (p + q) k p y = 0.
Proof.
move=> py e yq qk; split; last by rewrite /piece N_supp //; lia.
rewrite /piece (@N_left _ _ p q) ?eqxx //; last lia.
move=> d j h1 h2; by rewrite -(e (j + d)%N) // v_right // (e (j + d)%N) // (le_lt_trans (tle h1) py).
Qed.

(* T3.5.1 at t_m, limit from the left (last span s): 1 if i = s, else 0 *)
Theorem T3_5_1_tm m s k i : t s < t s.+1 -> t s.+1 = t m -> (s < m)%N -> (i + k < m)%N ->
  piece s k i (t m) = (i == s)%:R.
Proof.
move=> h1 h2 sm im.
rewrite /piece (@N_ext2 _ _ (fun d j => 1)); first by rewrite (@N_left _ _ s k).
move=> d j h3 h4 h5 h6; have e : t (j + d)%N = t m.
  apply/eqP; rewrite eq_le tle /=; last lia.
  by rewrite -h2 tle //; lia.
rewrite -e v_right // e -h2 (le_lt_trans _ h1) // tle //; lia.
Qed.

(* P3.1.3 and P4.2.1, open U with end knots of multiplicity k+1 exactly *)
Theorem P3_1_3_left k i : w_left w t -> t 0%N = t k -> t k < t k.+1 -> G w t k i (t 0%N) = (i == 0%N)%:R.
Proof.
move=> w0 e h; case: i => [|i]; first by rewrite T3_5_1_exception // add0n.
rewrite /=; apply: T3_5_1 => //.
  rewrite negb_and -!leNgt tle //.
move=> [h1 [h2 h3]]; move: h2; apply/eqP; rewrite lt_eqF // -h1 e.
by rewrite (lt_le_trans h) // tle //; lia.
Qed.
(* at t_m the functions but the last have the limit 0 *)
Theorem P3_1_3_right k n i : t n < t n.+1 -> t n.+1 = t (n + k.+1)%N -> (i <= n)%N ->
  piece n k i (t (n + k.+1)%N) = (i == n)%:R.
Proof. by move=> h1 h2 h3; apply: T3_5_1_tm => //; lia. Qed.

Variable V : lmodType R.
(* the curve begins in d_0 *)
Theorem P4_2_1_left k n (d : nat -> V) : w_left w t -> t 0%N = t k -> t k < t k.+1 -> curve w t k n d (t 0%N) = d 0%N.
Proof.
move=> w0 e h; rewrite /curve big_nat_recl // P3_1_3_left // scale1r big1 ?addr0 // => i _.
by rewrite P3_1_3_left // scale0r.
Qed.
(* and ends in d_n *)
Theorem P4_2_1_right k n (d : nat -> V) : t n < t n.+1 -> t n.+1 = t (n + k.+1)%N ->
  \sum_(0 <= i < n.+1) piece n k i (t (n + k.+1)%N) *: d i = d n.
Proof.
move=> h1 h2; rewrite big_nat_recr //= P3_1_3_right // eqxx scale1r big_nat_cond big1 ?add0r // => i hi.
rewrite P3_1_3_right //; last lia.
by have -> : (i == n) = false by [apply/eqP; lia]; rewrite scale0r.
Qed.
End Pieces.

(* multiplicity of a value among t_0..t_m *)
Definition mult (R : realFieldType) (t : nat -> R) m (y : R) : nat := count (fun i => t i == y) (iota 0 m.+1).

(* the knots equal to y: indices p+1..p+q, q <= mult *)
Lemma mult_span (R : realFieldType) (t : nat -> R) m y : (forall i, t i <= t i.+1) -> t 0%N < y < t m ->
  exists p q, [/\ t p < y, forall j, (p < j <= p + q)%N -> t j = y, y < t (p + q).+1, (p + q < m)%N & (q <= mult t m y)%N].
Proof.
move=> mono /andP[h0 hm].
have [p [pm p1 p2]] : exists p, [/\ (p < m)%N, t p < y & y <= t p.+1].
  elim: m hm => [|m IH] hm; first by move: (lt_trans h0 hm); rewrite ltxx.
  case: (ltP (t m) y) => h; first by exists m; split => //; apply: ltW.
  move: h; rewrite le_eqVlt => /orP[/eqP e|h]; last by have [p [*]] := IH h; exists p; split => //; lia.
  clear IH; move: h0; rewrite e; elim: m e {hm} => [|m IH] e h0; first by move: h0; rewrite ltxx.
  case: (ltP (t m) (t m.+1)) => h; first by exists m; split.
  have e2 : t m = t m.+1 by apply/eqP; rewrite eq_le h mono.
  by have [] := IH _ _; rewrite ?e2 // => p [*]; exists p; split => //; lia.
have [s [/andP[ps sm] /andP[s1 s2]]] : exists s, (p <= s < m)%N /\ t s <= y < t s.+1.
  by apply: span_exists => //; rewrite (ltW p1) hm.
have e j : (p < j <= s)%N -> t j = y.
  move=> /andP[j1 j2]; apply/eqP; rewrite eq_le (le_trans (t_le mono j2) s1) /=.
  exact: le_trans p2 (t_le mono j1).
exists p, (s - p)%N; rewrite subnKC //; split => //.
rewrite /mult (_ : m.+1 = p.+1 + ((s - p) + (m - s)))%N; last lia.
rewrite iotaD count_cat iotaD count_cat (@eq_in_count _ _ predT (iota (0 + p.+1) _)); last first.
  by move=> j; rewrite mem_iota => hj /=; rewrite e ?eqxx //; lia.
by rewrite count_predT size_iota; lia.
Qed.

(* ---- the paper's weight ---- *)
Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Definition mw (r : R) (t : nat -> R) (d i : nat) (x : R) : R := mob r x (t i) (t (i + d)%N).
Lemma wt_mw d i x : t i <= x < t (i + d)%N -> wt r t d i x = mw r t d i x.
Proof. exact: phi_in. Qed.
Lemma mw_left d i : t i < t (i + d)%N -> mw r t d i (t i) = 0.
Proof. by move=> _; apply: mob_a. Qed.
Lemma mw_right d i : t i < t (i + d)%N -> mw r t d i (t (i + d)%N) = 1.
Proof. by move=> h; apply: mob_b. Qed.
Definition P (r : R) (t : nat -> R) s k i x := piece (mw r t) s k i x.
Lemma G_P s k i x : t s <= x < t s.+1 -> G (wt r t) t k i x = P r t s k i x.
Proof. by move=> h; apply: G_piece => //; apply: wt_mw. Qed.
(* continuity: G at y (the value from the right) is the piece of the span to the left *)
Theorem P3_1_2_paper m k i y : t 0%N < y < t m -> (mult t m y <= k)%N ->
  exists p, [/\ t p < y, y <= t p.+1, (p < m)%N & G (wt r t) t k i y = P r t p k i y].
Proof.
move=> hy hk; have [p [q [h1 h2 h3 h4 h5]]] := mult_span t_mono hy.
exists p; split => //; last first.
- apply: (@P3_1_2_G _ _ (mw r t) t t_mono _ _ _ p q) => //.
  + exact: wt_mw.
  + exact: mw_left.
  + exact: mw_right.
  + exact: leq_trans hk.
- lia.
case: (posnP q) => q0; first by move: h3; rewrite q0 addn0 => /ltW.
by rewrite h2 //; lia.
Qed.
End Paper.
