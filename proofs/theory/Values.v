(* The value of G_i^k at every real x, as the claims have it: right-continuous, at t_m the limit from the left;
   knot vectors t_0 <= ... <= t_m, m = n+k+1, t_0 < t_m, and their adjectives. What stands behind t_m is never used. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Values.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.

(* the last span that is not empty below t_m *)
Fixpoint last_span (t : nat -> R) m : nat :=
  if m is p.+1 then if t p < t p.+1 then p else last_span t p else 0.
Lemma last_spanP m : t 0%N < t m ->
  [/\ (last_span t m < m)%N, t (last_span t m) < t (last_span t m).+1 & t (last_span t m).+1 = t m].
Proof.
elim: m => [|m IH] h; first by rewrite ltxx in h.
rewrite /=; case: (ltP (t m) (t m.+1)) => e; first by split.
have e2 : t m = t m.+1 by apply/eqP; rewrite eq_le e t_mono.
have [] := IH _; first by rewrite e2.
by rewrite e2 => h1 h2 h3; split => //; apply: leqW.
Qed.
Lemma last_span_uniq m s : t 0%N < t m -> (s < m)%N -> t s < t s.+1 -> t s.+1 = t m -> last_span t m = s.
Proof.
move=> h sm s1 s2; have [p1 p2 p3] := last_spanP h.
case: (ltngtP (last_span t m) s) => // c.
  by move: s1; rewrite ltNge s2 -p3 tle.
by move: p2; rewrite ltNge p3 -s2 tle.
Qed.
(* the first span that is not empty *)
Lemma first_spanP m : t 0%N < t m -> exists s, [/\ (s < m)%N, t s = t 0%N & t 0%N < t s.+1].
Proof.
move=> h; have [s [/andP[_ sm] /andP[s1 s2]]] := @span_exists R t t_mono 0 m (t 0%N) (introT andP (conj (lexx _) h)).
by exists s; split => //; apply/eqP; rewrite eq_le s1 tle.
Qed.

(* the value of G_i^k at x *)
Definition value (r : R) (t : nat -> R) m k i x : R :=
  if x < t m then G (wt r t) t k i x else if x == t m then P r t (last_span t m) k i x else 0.
Lemma value_in m k i x : x < t m -> value r t m k i x = G (wt r t) t k i x.
Proof. by rewrite /value => ->. Qed.
Lemma value_tm m k i : value r t m k i (t m) = P r t (last_span t m) k i (t m).
Proof. by rewrite /value ltxx eqxx. Qed.
Lemma value_out m k i x : t m < x -> value r t m k i x = 0.
Proof. by move=> h; rewrite /value ltNge (ltW h) /= gt_eqF. Qed.
(* at t_m the functions of all degrees are 0, but for that of the last span, which is 1 *)
Theorem value_tmE m k i : t 0%N < t m -> (i + k < m)%N -> value r t m k i (t m) = (i == last_span t m)%:R.
Proof.
move=> h im; have [p1 p2 p3] := last_spanP h; rewrite value_tm.
by apply: (@T3_5_1_tm _ (mw r t) t t_mono _ m (last_span t m)) => //; exact: mw_right.
Qed.
(* it is the limit from the left, with a one-sided derivative *)
Theorem value_left m k i : t 0%N < t m -> left_taylor (G (wt r t) t k i) (t m) (value r t m k i (t m)) (dP r t (last_span t m) k i (t m)).
Proof.
move=> h; have [p1 p2 p3] := last_spanP h; rewrite value_tm.
by apply: G_left => //; rewrite -p3 p2 lexx.
Qed.
(* ---- the spans on both sides of a point ---- *)
Fixpoint right_span (t : nat -> R) m (x : R) : nat := if m is p.+1 then if t p <= x then p else right_span t p x else 0.
Fixpoint left_span (t : nat -> R) m (x : R) : nat := if m is p.+1 then if t p < x then p else left_span t p x else 0.
Lemma right_spanP m x : t 0%N <= x < t m -> (right_span t m x < m)%N /\ t (right_span t m x) <= x < t (right_span t m x).+1.
Proof.
case/andP=> h0; elim: m => [|m IH] h; first by rewrite ltNge h0 in h.
rewrite /=; case: (leP (t m) x) => e; first by rewrite e h.
by have [h1 h2] := IH e; split => //; apply: leqW.
Qed.
Lemma left_spanP m x : t 0%N < x <= t m -> (left_span t m x < m)%N /\ t (left_span t m x) < x <= t (left_span t m x).+1.
Proof.
case/andP=> h0; elim: m => [|m IH] h; first by rewrite leNgt h0 in h.
rewrite /=; case: (ltP (t m) x) => e; first by rewrite e h.
by have [h1 h2] := IH e; split => //; apply: leqW.
Qed.
Lemma right_span_uniq m x s : (s < m)%N -> t s <= x < t s.+1 -> right_span t m x = s.
Proof.
move=> sm /andP[s1 s2]; have [] := @right_spanP m x; first by rewrite (le_trans (tle (leq0n s)) s1) (lt_le_trans s2) ?tle.
move=> pm /andP[p1 p2]; case: (ltngtP (right_span t m x) s) => // c.
  by move: p2; rewrite ltNge (le_trans (tle c) s1).
by move: s2; rewrite ltNge (le_trans (tle c) p1).
Qed.
Lemma left_span_uniq m x s : (s < m)%N -> t s < x <= t s.+1 -> left_span t m x = s.
Proof.
move=> sm /andP[s1 s2]; have [] := @left_spanP m x; first by rewrite (le_lt_trans (tle (leq0n s)) s1) (le_trans s2) ?tle.
move=> pm /andP[p1 p2]; case: (ltngtP (left_span t m x) s) => // c.
  by move: s1; rewrite ltNge (le_trans p2) ?tle.
by move: p1; rewrite ltNge (le_trans s2) ?tle.
Qed.
Lemma left_span_tm m : t 0%N < t m -> left_span t m (t m) = last_span t m.
Proof. by move=> h; have [p1 p2 p3] := last_spanP h; apply: left_span_uniq => //; rewrite -p3 p2 lexx. Qed.

(* limit from the left, derivatives from the left and from the right *)
Definition limit_left (r : R) (t : nat -> R) m k i x : R := P r t (left_span t m x) k i x.
Definition Dleft (r : R) (t : nat -> R) m k i x : R := dP r t (left_span t m x) k i x.
Definition Dright (r : R) (t : nat -> R) m k i x : R := dP r t (right_span t m x) k i x.
(* Dleft and limit_left are the derivative and the limit from the left *)
Theorem DleftP m k i x : t 0%N < x <= t m ->
  left_taylor (G (wt r t) t k i) x (limit_left r t m k i x) (Dleft r t m k i x).
Proof. by move=> /left_spanP[_ h]; apply: G_left. Qed.
(* Dright is the derivative from the right, where the limit is the value *)
Theorem DrightP m k i x : t 0%N <= x < t m ->
  right_taylor (G (wt r t) t k i) x (value r t m k i x) (Dright r t m k i x).
Proof.
move=> h; have [_ hs] := right_spanP h; rewrite value_in; last by case/andP: h.
by rewrite (G_P r t_mono _ _ hs); apply: G_right.
Qed.
(* the derivatives of a weight from the two sides; 0 on an empty interval *)
Definition wDright (r : R) (t : nat -> R) d j x : R := if t j <= x < t (j + d)%N then dmw r t d j x else 0.
Definition wDleft (r : R) (t : nat -> R) d j x : R := if t j < x <= t (j + d)%N then dmw r t d j x else 0.
(* wDright is the derivative of the weight from the right *)
Theorem wDrightP d j x : right_taylor (wt r t d j) x (wt r t d j x) (wDright r t d j x).
Proof.
rewrite /wDright /wt; case: (boolP (t j <= x < t (j + d)%N)) => [/andP[h1 h2]|h].
  have [g [e [bg e0 hg]]] := mob_taylor r_gt0 h1 (ltW h2) (le_lt_trans h1 h2).
  exists g, (Num.min e (t (j + d)%N - x)); split => //; first by rewrite lt_minr e0 subr_gt0.
  move=> a /andP[a0]; rewrite lt_minr => /andP[a1 a2].
  rewrite !phi_in ?h1 ?h2 //; last by rewrite (le_trans h1) ?ler_addl //= addrC -ltr_subr_addr.
  by rewrite hg // ger0_norm.
exists (fun _ => 0); rewrite {2}/phi (negbTE h); move: h; rewrite negb_and -ltNge -leNgt; case: (ltP x (t j)) => /= [h _|_ h].
  exists (t j - x); split; [exact: bnd_const|by rewrite subr_gt0|].
  move=> a /andP[a0 a1]; rewrite /phi leNgt -ltr_subr_addl a1 /=; ring.
exists 1; split; [exact: bnd_const|exact: ltr01|].
by move=> a /andP[a0 a1]; rewrite /phi [x + a < _]ltNge (le_trans h) ?ler_addl // andbF; ring.
Qed.
(* wDleft is the derivative of the weight from the left, with the limit of the weight *)
Theorem wDleftP d j x : left_taylor (wt r t d j) x (if t j < x <= t (j + d)%N then mw r t d j x else 0) (wDleft r t d j x).
Proof.
rewrite /wDleft; case: (boolP (t j < x <= t (j + d)%N)) => [/andP[h1 h2]|h].
  have [g [e [[C [c [C0 c0 Cg]]] e0 hg]]] := mob_taylor r_gt0 (ltW h1) h2 (lt_le_trans h1 h2).
  exists (fun a => g (- a)), (Num.min e (x - t j)); split; first by exists C, c; split => // a ha; apply: Cg; rewrite normrN.
    by rewrite lt_minr e0 subr_gt0.
  move=> a /andP[a0]; rewrite lt_minr => /andP[a1 a2].
  rewrite /wt phi_in; first by rewrite hg ?normrN ?ger0_norm ?(ltW a0) // sqrrN mulrN.
  by rewrite ler_subr_addr addrC -ler_subr_addr (ltW a2) /= (lt_le_trans _ h2) // ltr_subl_addr ltr_addl.
exists (fun _ => 0); move: h; rewrite negb_and -leNgt -ltNge; case: (leP x (t j)) => /= [h _|_ h].
  exists 1; split; [exact: bnd_const|exact: ltr01|].
  move=> a /andP[a0 _]; rewrite /wt /phi leNgt (lt_le_trans _ h) ?ltr_subl_addr ?ltr_addl //=; ring.
exists (x - t (j + d)%N); split; [exact: bnd_const|by rewrite subr_gt0|].
move=> a /andP[a0 a1]; rewrite /wt /phi [x - a < _]ltNge; have -> : t (j + d)%N <= x - a by rewrite ler_subr_addr addrC -ler_subr_addr ltW.
by rewrite andbF; ring.
Qed.
End Values.

Section Adjectives.
Variable R : realFieldType.
Variable t : nat -> R.
Variables n k : nat.
Let m := (n + k.+1)%N.
(* U open; m >= 2k follows from t_k < t_(n+1) *)
Definition Uopen := [/\ t 0%N = t k, t n.+1 = t m & t k < t n.+1].
Definition Uclamped := [/\ Uopen, t k < t k.+1 & t n < t n.+1].
Definition Usymmetric := forall i, (i <= m)%N -> t (m - i)%N = t 0%N + t m - t i.
Definition Uinterior := forall j, (k < j <= n)%N -> (mult t m (t j) <= k)%N.
Definition Uinner := forall y, t 0%N < y < t m -> (mult t m y <= k)%N.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Lemma Uopen_kn : t k < t n.+1 -> (k <= n)%N.
Proof. by move=> h; have := t_lt_ltn t_mono h. Qed.
Lemma Uopen_t0 : Uopen -> t 0%N < t m.
Proof. by case=> -> <-. Qed.

(* knots y of multiplicity q: indices p+1..p+q, and no others *)
Lemma mult_span_eq y : t 0%N < y < t m ->
  exists p, [/\ t p < y, forall j, (p < j <= p + mult t m y)%N -> t j = y, y < t (p + mult t m y).+1 & (p + mult t m y < m)%N].
Proof.
move=> hy; have [p [q [h1 h2 h3 h4 h5]]] := mult_span t_mono hy.
exists p; suff -> : mult t m y = q by split.
apply/eqP; rewrite eqn_leq h5 andbT /mult.
have -> : (m.+1 = p.+1 + (q + (m - (p + q))))%N by move: h4; clear; lia.
rewrite iotaD count_cat iotaD count_cat (@eq_in_count _ _ pred0 (iota 0 _)); last first.
  by move=> j; rewrite mem_iota => /andP[_ hj] /=; apply: lt_eqF; apply: le_lt_trans h1; apply: tle; rewrite -ltnS.
rewrite (@eq_in_count _ _ pred0 (iota (0 + p.+1 + q) _)); last first.
  move=> j; rewrite mem_iota => /andP[hj _] /=; apply: gt_eqF; apply: (lt_le_trans h3); apply: tle.
  by move: hj; rewrite add0n addSn.
by rewrite !count_pred0 addn0 add0n (leq_trans (count_size _ _)) // size_iota.
Qed.

(* the adjective "interior" bounds every multiplicity inside (t_0, t_m) *)
Lemma Uinterior_inner : t k < t n.+1 -> Uinterior -> Uinner.
Proof.
move=> h H y hy; have [p [h1 h2 h3 h4]] := mult_span_eq hy.
set q := mult t m y in h2 h3 h4 *; rewrite leqNgt; apply/negP => qk.
have e j : (p < j <= p + q)%N -> ~~ (k < j <= n)%N.
  move=> hj; apply/negP => /H; rewrite (h2 j hj) -/q; move: qk; clear; lia.
have pk : (p < k)%N -> (p + q <= k)%N.
  move=> pk; rewrite leqNgt; apply/negP => c; have := e k.+1; rewrite ltnS (ltnW pk) c ltnSn /= => /(_ isT).
  rewrite -ltnNge ltnS => nk; have kn := Uopen_kn h; have ek : k = n by apply/eqP; rewrite eqn_leq kn nk.
  move: h; rewrite (h2 k) ?pk ?(ltnW c) // (h2 n.+1) ?ltxx // -ek ltnS (ltnW pk) //.
move: pk; case: (ltnP p k) => pk; first by move=> /(_ isT) c; move: qk c; clear; lia.
move=> _; have := e p.+1; rewrite ltnSn /= => /(_ _).
have -> : (p < p + q)%N by move: qk; clear; lia.
move=> /(_ isT); rewrite ltnS pk /= -ltnNge => np.
by move: h4; rewrite /m; move: qk np; clear; lia.
Qed.
End Adjectives.
