(* The claims about the basis (section 3, first half), each as its stanza says it, for every degree.
   U is t_0 <= ... <= t_m, t_0 < t_m, m = n+k+1; value is G_i^k(x), at t_m the limit from the left. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Symmetry Derivatives Values.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Statements.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Hypothesis U : t 0%N < t m.
Let tle := t_le t_mono.
Local Notation value := (value r t m).
Let ri : 0 < r^-1. Proof. by rewrite invr_gt0. Qed.

(* T3.5.1 as amended: 0 outside of the open support, but for the two ends at which it is 1 *)
Theorem T3_5_1_amended i x : (i <= n)%N ->
  ~~ (t i < x < t (i + k.+1)%N) ->
  ~ (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N) ->
  ~ (t i < t i.+1 /\ t i.+1 = t m /\ t m = x) -> value k i x = 0.
Proof.
move=> im h1 h2 h3; case: (ltgtP x (t m)) => hx.
- by rewrite value_in //; apply: T3_5_1 => //; apply: wt_left.
- by rewrite value_out.
rewrite hx value_tmE //; last by rewrite -addSnnS ltnS leq_add2r.
case: (eqVneq i _) => // e; case: h3; have [p1 p2 p3] := last_spanP t_mono U.
by rewrite e; split => //; split; rewrite ?p3.
Qed.
(* T3.5.1, the exceptions: it is 1 there *)
Theorem T3_5_1_fails i x : (i <= n)%N ->
  (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N) \/ (t i < t i.+1 /\ t i.+1 = t m /\ t m = x) -> value k i x = 1.
Proof.
move=> im [[-> [e h]]|[h1 [h2 <-]]].
  rewrite value_in ?T3_5_1_exception //; first exact: wt_left.
  by rewrite e (lt_le_trans h) // tle // leq_add2r.
rewrite value_tmE //; last by rewrite -addSnnS ltnS leq_add2r.
by rewrite (@last_span_uniq _ _ t_mono m i) ?eqxx //; move: im; clear; lia.
Qed.
(* T3.5.2 *)
Theorem T3_5_2_printed i x : (i <= n)%N -> t i < x < t (i + k.+1)%N -> 0 < value k i x.
Proof.
move=> im h; rewrite value_in; last by case/andP: h => _ h; apply: (lt_le_trans h); rewrite tle // leq_add2r.
by apply: T3_5_2 => //; [exact: wt_left|exact: wt_range|exact: wt_inside].
Qed.
(* no value is negative, that at t_m included *)
Theorem value_ge0 i x : (i <= n)%N -> 0 <= value k i x.
Proof.
move=> im; case: (ltgtP x (t m)) => hx.
- by rewrite value_in //; apply: T3_5_2_nonneg; apply: wt_range.
- by rewrite value_out.
by rewrite hx value_tmE ?ler0n // -addSnnS ltnS leq_add2r.
Qed.
Lemma in_span j x : (j < m)%N -> t j <= x < t j.+1 -> x < t m.
Proof. by move=> jm /andP[_ h]; apply: (lt_le_trans h); apply: tle. Qed.
(* T3.5.3 as amended *)
Theorem T3_5_3_amended j x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  \sum_(0 <= i < n.+1) value k i x = \sum_(j - k <= i < j.+1) value k i x /\ \sum_(0 <= i < n.+1) value k i x = 1.
Proof.
move=> hj hx; have xm : x < t m by apply: (in_span _ hx); move: hj; clear; lia.
have E a b : \sum_(a <= i < b) value k i x = \sum_(a <= i < b) G (wt r t) t k i x.
  by apply: eq_bigr => i _; rewrite value_in.
by rewrite !E; apply: T3_5_3.
Qed.
(* T3.5.3 on every other span: the sum is less than 1 *)
Theorem T3_5_3_fails j x : (j < m)%N -> ~~ (k <= j <= n)%N -> t j < x < t j.+1 -> \sum_(0 <= i < n.+1) value k i x < 1.
Proof.
move=> jm hj /andP[x1 x2]; have xm : x < t m by apply: (in_span jm); rewrite (ltW x1).
rewrite (eq_bigr (fun i => G (wt r t) t k i x)); last by move=> i _; rewrite value_in.
apply: T3_5_3_sharp => //; [exact: wt_left|exact: wt_range|exact: wt_inside| |].
  by move: jm hj; clear; lia.
case: (ltnP j k) => jk; [left|right].
  by rewrite (le_lt_trans (tle (leq0n j)) x1) (lt_le_trans x2) // tle.
have nj : (n < j)%N by move: hj jk; clear; lia.
by rewrite (le_lt_trans (tle nj) x1) xm.
Qed.

(* T3.5.4 as amended: x any point of [t_0, t_m], at an inner knot of multiplicity > k excepted *)
Theorem T3_5_4_amended i x : Usymmetric t n k -> (i <= n)%N -> t 0%N <= x <= t m ->
  x = t 0%N \/ x = t m \/ (mult t m x <= k)%N ->
  value k i (t 0%N + t m - x) = Values.value r^-1 t m k (n - i) x.
Proof.
move=> sym im /andP[x0 xm] hx.
have [f [fm f0 f1]] := first_spanP t_mono U.
have [sm s1 s2] := last_spanP t_mono U; set s := last_span t m in sm s1 s2.
have tf1 : t (m - 1 - f)%N < t (m - 1 - f).+1.
  have -> : (m - 1 - f = m - f.+1)%N by move: fm; clear; lia.
  have -> : ((m - f.+1).+1 = m - f)%N by move: fm; clear; lia.
  by rewrite !sym ?(ltnW fm) // f0 ltr_add2l ltr_opp2.
have fs : (m - 1 - f)%N = s.
  apply/esym/last_span_uniq => //; first by move: fm; clear; lia.
  have -> : ((m - 1 - f).+1 = m - f)%N by move: fm; clear; lia.
  by rewrite sym ?(ltnW fm) // f0 [t 0%N + t m]addrC addrK.
have K1 : value k i (t m) = Values.value r^-1 t m k (n - i) (t 0%N).
  rewrite value_tm value_in // -/s -fs.
  rewrite (G_P r^-1 t_mono _ _ (s := f)); last by rewrite f0 lexx.
  have {1}-> : t m = t 0%N + t m - t 0%N by rewrite [t 0%N + t m]addrC addrK.
  by apply: T3_5_4_sided => //; [rewrite f0|rewrite f0 lexx ltW].
have K2 : value k i (t 0%N) = Values.value r^-1 t m k (n - i) (t m).
  rewrite value_in // value_tm -/s.
  have fs' : (m - 1 - s = f)%N by rewrite -fs; move: fm; clear; lia.
  rewrite (G_P r t_mono _ _ (s := f)); last by rewrite f0 lexx.
  have {1}-> : t 0%N = t 0%N + t m - t m by rewrite addrK.
  rewrite -fs'; apply: T3_5_4_sided => //; by rewrite s2 lexx (le_trans (ltW s1)) // s2.
case: (eqVneq x (t 0%N)) => [->|n0]; first by rewrite [t 0%N + t m]addrC addrK.
case: (eqVneq x (t m)) => [->|n1]; first by rewrite addrK.
have hk : (mult t m x <= k)%N by case: hx => [e|[e|//]]; [move: n0|move: n1]; rewrite e eqxx.
have hx' : t 0%N < x < t m by rewrite !lt_neqAle eq_sym n0 x0 n1 xm.
rewrite !value_in; first exact: T3_5_4.
  by case/andP: hx'.
by rewrite ltr_subl_addr addrC ltr_add2l; case/andP: hx'.
Qed.
(* T3.5.4 at an inner knot of multiplicity > k: it fails for some i *)
Theorem T3_5_4_fails x : Usymmetric t n k -> t 0%N < x < t m -> (k < mult t m x)%N ->
  exists i, (i <= n)%N /\ value k i (t 0%N + t m - x) != Values.value r^-1 t m k (n - i) x.
Proof.
move=> sym hx; have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hx; set q := mult t m x in p2 p3 p4 *.
move=> kq; exists (m - 1 - p - q)%N; split; first by move: kq p4; clear; lia.
have -> : (n - (m - 1 - p - q) = p + q - k)%N by move: kq p4; clear; lia.
case/andP: hx => x0 xm; rewrite !value_in //; last by rewrite ltr_subl_addr addrC ltr_add2l.
have e1 : (p + q - k + k = p + q)%N by move: kq; clear; lia.
have e2 : t (p + q - k)%N = x by apply: p2; move: kq; clear; lia.
have e3 : t (p + q)%N = x by apply: p2; move: kq; clear; lia.
have -> : G (wt r^-1 t) t k (p + q - k) x = 1.
  rewrite -[x in LHS]e2; apply: T3_5_1_exception => //; first exact: wt_left.
    by rewrite e1 e2 e3.
  by rewrite addnS e1 e3.
rewrite T3_5_1_outside //; first by rewrite eq_sym oner_neq0.
rewrite negb_and -!ltNge -leNgt; apply/orP; right.
have -> : (m - 1 - p - q + k.+1 = m - (p + q - k))%N by move: kq p4; clear; lia.
rewrite sym; first by rewrite e2.
by move: kq p4; clear; lia.
Qed.

(* L3.6: at t_0 the functions of the degrees k-q and k-q-1 have the same values *)
Lemma phi_le (x a b : R) : x <= a -> phi r x a b = 0.
Proof.
move=> h; rewrite /phi; case: ifP => // /andP[ax _].
by have -> : x = a by [apply/eqP; rewrite eq_le h ax]; rewrite mob_a.
Qed.
(* L3.6: both equations, 0 ≤ q ≤ k−1 *)
Theorem L3_6_printed q : Uopen t n k -> (q < k)%N ->
  value (k - q) q (t 0%N) = value (k - q.+1) q.+1 (t 0%N) /\ value (k - q) q.+1 (t 0%N) = value (k - q.+1) q.+2 (t 0%N).
Proof.
move=> _ qk; rewrite !value_in //.
have -> : (k - q = (k - q.+1).+1)%N by move: qk; clear; lia.
by rewrite !GS /wt !phi_le ?tle // !mul0r !add0r !subr0 !mul1r.
Qed.
(* L3.7: and at t_m *)
Theorem L3_7_printed q : Uopen t n k -> (q < k)%N ->
  value (k - q) n (t m) = value (k - q.+1) n (t m) /\ ((2 <= k)%N -> value (k - q) n.-1 (t m) = value (k - q.+1) n.-1 (t m)).
Proof. by move=> _ qk; rewrite !value_tmE //; move: qk; clear; lia. Qed.

(* P3.1.2: continuous on [t_0, t_m), if no interior knot has multiplicity > k *)
Theorem P3_1_2_printed i x : Uinterior t n k -> t k < t n.+1 -> (i <= n)%N -> t 0%N <= x < t m ->
  (exists l, right_taylor (G (wt r t) t k i) x (value k i x) l) /\
  (t 0%N < x -> exists l, left_taylor (G (wt r t) t k i) x (value k i x) l).
Proof.
move=> hi h _ /andP[x0 xm]; rewrite value_in //; split.
  have [s [_ hs]] : exists s, (0 <= s < m)%N /\ t s <= x < t s.+1 by apply: span_exists => //; rewrite x0.
  by exists (dP r t s k i x); rewrite (G_P r t_mono _ _ hs); apply: G_right.
move=> x0'; have hx : t 0%N < x < t m by rewrite x0'.
have [l [l' [h1 _]]] := P3_1_2_limits r_gt0 t_mono i hx (Uinterior_inner t_mono h hi hx).
by exists l.
Qed.
(* P3.1.3 as amended: the values at the ends, end knots of multiplicity k+1 exactly *)
Theorem P3_1_3_amended : Uclamped t n k ->
  [/\ value k 0 (t 0%N) = 1, forall i, (1 <= i <= n)%N -> value k i (t 0%N) = 0,
      value k n (t m) = 1 & forall i, (i < n)%N -> value k i (t m) = 0].
Proof.
case=> [[e0 e1 e2] h1 h2].
have s : last_span t m = n by apply: last_span_uniq => //; clear; lia.
split.
- by rewrite value_in // P3_1_3_left //; apply: wt_left.
- move=> i /andP[i1 i2]; rewrite value_in // P3_1_3_left //; last exact: wt_left.
  by have -> : (i == 0%N) = false by [apply/eqP; move: i1; clear; lia].
- by rewrite value_tmE ?s ?eqxx //; clear; lia.
move=> i im; rewrite value_tmE ?s //; last by move: im; clear; lia.
by have -> : (i == n) = false by [apply/eqP; move: im; clear; lia].
Qed.
(* P3.1.3 fails if an end knot occurs more often *)
Theorem P3_1_3_fails : Uopen t n k -> t k = t k.+1 \/ t n = t n.+1 -> value k 0 (t 0%N) = 0 \/ value k n (t m) = 0.
Proof.
case=> e0 e1 e2 [h|h]; [left|right].
  by rewrite value_in // T3_5_1_outside // negb_and -leNgt add0n -h e0 lexx orbT.
rewrite value_tmE //; last by clear; lia.
case: eqP => // e; have [_ p2 _] := last_spanP t_mono U.
by move: p2; rewrite -e h ltxx.
Qed.
(* P3.1, after it: the limit at t_m exists *)
Theorem P3_1_extension i : (i <= n)%N -> exists v l, left_taylor (G (wt r t) t k i) (t m) v l.
Proof. by move=> _; exists (value k i (t m)), (dP r t (last_span t m) k i (t m)); apply: value_left. Qed.

(* P4.1.3: factors of a convex combination at every x of [t_0,t_m], U open *)
Theorem P4_1_3_printed x : Uopen t n k -> t 0%N <= x <= t m ->
  (forall i, (i <= n)%N -> 0 <= value k i x) /\ \sum_(0 <= i < n.+1) value k i x = 1.
Proof.
move=> [e0 e1 e2] /andP[x0 xm]; split; first by move=> i im; apply: value_ge0.
case: (ltP x (t m)) => h.
  have [s [hs hx]] : exists s, (k <= s < n.+1)%N /\ t s <= x < t s.+1.
    by apply: span_exists => //; rewrite -e0 x0 e1.
  by have [] := @T3_5_3_amended s x _ hx; first by move: hs; clear; lia.
have -> : x = t m by apply/eqP; rewrite eq_le xm h.
have kn := Uopen_kn t_mono e2; have [p1 p2 p3] := last_spanP t_mono U.
have sn : (last_span t m <= n)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite e1 -p3.
rewrite (eq_big_nat _ _ (F2 := fun i => (i == last_span t m)%:R)); last first.
  by move=> i /andP[_ hi]; rewrite value_tmE //; move: hi; clear; lia.
rewrite (bigD1_seq (last_span t m)) ?mem_index_iota ?iota_uniq //= eqxx big1 ?addr0 //.
by move=> i /negbTE ->.
Qed.
End Statements.
