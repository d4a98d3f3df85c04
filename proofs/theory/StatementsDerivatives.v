(* The claims about derivatives (section 3, second half), each as its stanza says it, for every degree. Dleft, Dright and
   limit_left are the numbers that the one-sided expansions DleftP, DrightP of Values.v determine. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Jumps RationalDerivative Theorem3 Values.
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
Local Notation G := (G (wt r t) t).
Local Notation value := (value r t m).
Local Notation Dright := (Dright r t m).
Local Notation Dleft := (Dleft r t m).
Local Notation limit_left := (limit_left r t m).
Local Notation wDright := (wDright r t).
Local Notation wDleft := (wDleft r t).

(* ---- at t_0: s is the span right of it, t_0 = .. = t_s ---- *)
Section First.
Variable s : nat.
Hypothesis sm : (s < m)%N.
Hypothesis s0 : t s = t 0%N.
Hypothesis s1 : t 0%N < t s.+1.
Lemma first_knots j : (j <= s)%N -> t j = t 0%N.
Proof. by move=> h; apply/eqP; rewrite eq_le -{1}s0 !tle. Qed.
Lemma Dright_t0 d i : Dright d i (t 0%N) = dP r t s d i (t 0%N).
Proof. by rewrite /Values.Dright (@right_span_uniq _ _ t_mono m _ s) // s0 lexx. Qed.
Let w0 e j : (j <= s < j + e)%N -> mw r t e j (t 0%N) = 0.
Proof. by move=> /andP[h _]; rewrite /mw -(first_knots h) mob_a. Qed.
Lemma Dright_t0_step d i : Dright d.+1 i (t 0%N) =
  Dright d i.+1 (t 0%N) + ((i + d == s)%N%:R * dmw r t d.+1 i (t 0%N) - (i.+1 + d == s)%N%:R * dmw r t d.+1 i.+1 (t 0%N)).
Proof. by rewrite !Dright_t0 /dP (dN_start_step _ w0). Qed.
Lemma Dright_t0E d i : Dright d i (t 0%N) =
  ((i + d == s.+1)%N%:R - (i + d == s)%N%:R) * \sum_(1 <= e < d.+1) dmw r t e (s.+1 - e)%N (t 0%N).
Proof. by rewrite Dright_t0 /dP (dN_start _ w0). Qed.
Lemma dmw_t0 d j : (j <= s < j + d)%N -> 0 < dmw r t d j (t 0%N).
Proof.
move=> /andP[h1 h2]; have lt : t 0%N < t (j + d)%N by apply: (lt_le_trans s1); apply: tle.
by rewrite /dmw (first_knots h1) dmob_a // divr_gt0 // subr_gt0.
Qed.
Lemma wDright_t0 d j : (j <= s < j + d)%N -> wDright d j (t 0%N) = dmw r t d j (t 0%N).
Proof.
move=> /andP[h1 h2]; rewrite /Values.wDright (first_knots h1) lexx /=.
by rewrite (lt_le_trans s1) // tle.
Qed.
End First.

(* L3.8 as amended: the three lines *)
Theorem L3_8_amended q : Uopen t n k -> (q < k)%N -> t k < t k.+1 ->
  [/\ Dright (k - q) q (t 0%N) = Dright (k - q.+1) q.+1 (t 0%N) - wDright (k - q) q.+1 (t 0%N),
      Dright (k - q) q.+1 (t 0%N) = Dright (k - q.+1) q.+2 (t 0%N) + wDright (k - q) q.+1 (t 0%N) &
      forall i, (2 <= i <= n)%N -> Dright (k - q) (q + i) (t 0%N) = Dright (k - q.+1) (q + i).+1 (t 0%N)].
Proof.
case=> e0 e1 e2 qk h; have kn := Uopen_kn t_mono e2.
have km : (k < m)%N by move: kn; clear; lia.
have s1 : t 0%N < t k.+1 by rewrite e0.
have E : (k - q = (k - q.+1).+1)%N by move: qk; clear; lia.
rewrite (wDright_t0 (esym e0) s1); last by move: qk; clear; lia.
rewrite E; split=> [||i hi]; rewrite (Dright_t0_step km (esym e0) s1).
- have -> : (q + (k - q.+1) == k)%N = false by apply/eqP; move: qk; clear; lia.
  have -> : (q.+1 + (k - q.+1) == k)%N by apply/eqP; move: qk; clear; lia.
  by rewrite mul0r mul1r sub0r.
- have -> : (q.+1 + (k - q.+1) == k)%N by apply/eqP; move: qk; clear; lia.
  have -> : (q.+2 + (k - q.+1) == k)%N = false by apply/eqP; move: qk; clear; lia.
  by rewrite mul0r mul1r subr0.
have -> : (q + i + (k - q.+1) == k)%N = false by apply/eqP; move: qk hi; clear; lia.
have -> : ((q + i).+1 + (k - q.+1) == k)%N = false by apply/eqP; move: qk hi; clear; lia.
by rewrite !mul0r subr0 addr0.
Qed.
(* L3.8 fails if the first knot occurs more than k+1 times *)
Theorem L3_8_fails q : Uopen t n k -> (q < k)%N -> t k = t k.+1 ->
  exists i, (1 <= i <= n)%N /\ Dright (k - q) (q + i) (t 0%N) != Dright (k - q.+1) (q + i).+1 (t 0%N).
Proof.
case=> e0 e1 e2 qk h; have [s [sm s0 s1]] := first_spanP t_mono U.
have ks : (k < s)%N by rewrite ltnNge; apply/negP => c; move: s1; rewrite ltNge e0 h tle.
have sn : (s <= n)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite s0 e0.
exists (s - k.-1)%N; split; first by move: qk ks sn; clear; lia.
have -> : (k - q = (k - q.+1).+1)%N by move: qk; clear; lia.
rewrite (Dright_t0_step sm s0 s1).
have -> : (q + (s - k.-1) + (k - q.+1) == s)%N by apply/eqP; move: qk ks; clear; lia.
have -> : ((q + (s - k.-1)).+1 + (k - q.+1) == s)%N = false by apply/eqP; move: qk ks; clear; lia.
rewrite mul1r mul0r subr0 -subr_eq0 addrC addKr gt_eqF // (dmw_t0 s0 s1) //.
by move: qk ks; clear; lia.
Qed.

(* ---- at t_m: s is the span left of it, t_(s+1) = .. = t_m ---- *)
Section Last.
Let s := last_span t m.
Let sm : (s < m)%N. Proof. by have [] := last_spanP t_mono U. Qed.
Let s0 : t s < t s.+1. Proof. by have [] := last_spanP t_mono U. Qed.
Let s1 : t s.+1 = t m. Proof. by have [] := last_spanP t_mono U. Qed.
Lemma last_knots j : (s < j <= m)%N -> t j = t m.
Proof. by move=> /andP[h1 h2]; apply/eqP; rewrite eq_le -{2}s1 !tle. Qed.
Lemma Dleft_tm d i : Dleft d i (t m) = dP r t s d i (t m).
Proof. by rewrite /Values.Dleft left_span_tm. Qed.
Let w1 e j : (j <= s < j + e)%N -> (j + e <= m)%N -> mw r t e j (t m) = 1.
Proof.
move=> /andP[h1 h2] h3; have E : t (j + e)%N = t m by apply: last_knots; rewrite h2.
by rewrite /mw E mob_b // -s1 (le_lt_trans (tle h1)).
Qed.
Lemma Dleft_tm_step d i : (i + d.+1 < m)%N -> Dleft d.+1 i (t m) =
  Dleft d i (t m) + ((i == s)%:R * dmw r t d.+1 i (t m) - (i.+1 == s)%:R * dmw r t d.+1 i.+1 (t m)).
Proof. by move=> h; rewrite !Dleft_tm /dP (dN_stop_step _ w1). Qed.
Lemma Dleft_tmE d i : (i + d < m)%N -> Dleft d i (t m) =
  ((i == s)%:R - (i.+1 == s)%:R) * \sum_(1 <= e < d.+1) dmw r t e s (t m).
Proof. by move=> h; rewrite Dleft_tm /dP (dN_stop _ w1). Qed.
Lemma dmw_tm d j : (j <= s < j + d)%N -> (j + d <= m)%N -> 0 < dmw r t d j (t m).
Proof.
move=> /andP[h1 h2] h3; have E : t (j + d)%N = t m by apply: last_knots; rewrite h2.
have lt : t j < t m by rewrite -s1 (le_lt_trans (tle h1)).
by rewrite /dmw E dmob_b // divr_gt0 ?invr_gt0 // subr_gt0.
Qed.
Lemma wDleft_tm d j : (j <= s < j + d)%N -> (j + d <= m)%N -> wDleft d j (t m) = dmw r t d j (t m).
Proof.
move=> /andP[h1 h2] h3; have E : t (j + d)%N = t m by apply: last_knots; rewrite h2.
by rewrite /Values.wDleft E lexx andbT -s1 (le_lt_trans (tle h1)).
Qed.
Lemma wDleft_tm0 d j : (s < j <= m)%N -> wDleft d j (t m) = 0.
Proof. by move=> h; rewrite /Values.wDleft (last_knots h) ltxx. Qed.
(* how often t_m occurs *)
Lemma mult_tm : mult t m (t m) = (m - s)%N.
Proof.
rewrite /mult; have -> : (m.+1 = s.+1 + (m - s))%N by move: sm; clear; lia.
rewrite iotaD count_cat (@eq_in_count _ _ pred0 (iota 0 _)); last first.
  by move=> j; rewrite mem_iota => /andP[_ hj] /=; apply: lt_eqF; rewrite -s1 (le_lt_trans _ s0) // tle // -ltnS.
rewrite (@eq_in_count _ _ predT (iota (0 + s.+1) _)); last first.
  by move=> j; rewrite mem_iota => hj /=; rewrite last_knots ?eqxx //; move: hj sm; clear; lia.
by rewrite count_pred0 count_predT size_iota.
Qed.
Lemma last_open : Uopen t n k -> (k <= s <= n)%N.
Proof.
case=> e0 e1 e2; apply/andP; split.
  by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite s1 -e1.
by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite e1 -s1.
Qed.

(* L3.9 as amended *)
Theorem L3_9_amended q : Uopen t n k -> (q < k)%N -> mult t m (t m) != k.+2 ->
  Dleft (k - q) n (t m) = Dleft (k - q.+1) n (t m) + wDleft (k - q) n (t m) /\
  Dleft (k - q) n.-1 (t m) = Dleft (k - q.+1) n.-1 (t m) - wDleft (k - q) n (t m).
Proof.
move=> ho qk; rewrite mult_tm => hm; have /andP[ks sn] := last_open ho.
have E : (k - q = (k - q.+1).+1)%N by move: qk; clear; lia.
have n0 : (0 < n)%N by move: qk ks sn; clear; lia.
rewrite E !Dleft_tm_step; try (move: qk n0; clear; lia).
have -> : (n.+1 == s) = false by apply/eqP; move: sn; clear; lia.
have -> : (n.-1 == s) = false by apply/eqP; move: hm sn n0; clear; move=> /eqP; lia.
rewrite (ltn_predK n0) !mul0r subr0 sub0r; case: (eqVneq n s) => e.
  by rewrite mul1r wDleft_tm //; move: e qk; clear; lia.
by rewrite wDleft_tm0 ?mul0r ?oppr0 //; move: e sn; clear; move=> /eqP; lia.
Qed.
(* L3.9, the exception *)
Theorem L3_9_fails q : Uopen t n k -> (q < k)%N -> mult t m (t m) = k.+2 ->
  Dleft (k - q) n.-1 (t m) != Dleft (k - q.+1) n.-1 (t m) - wDleft (k - q) n (t m).
Proof.
move=> ho qk; rewrite mult_tm => hm; have /andP[ks sn] := last_open ho.
have E : (k - q = (k - q.+1).+1)%N by move: qk; clear; lia.
have n0 : (0 < n)%N by move: qk ks sn; clear; lia.
have es : s = n.-1 by move: hm sm n0; clear; lia.
rewrite E Dleft_tm_step; last by move: qk n0; clear; lia.
rewrite es eqxx; have -> : (n.-1.+1 == n.-1) = false by apply/eqP; clear; lia.
rewrite mul0r subr0 mul1r wDleft_tm0; last by rewrite es; move: n0; clear; lia.
rewrite subr0 -subr_eq0 addrC addKr gt_eqF // dmw_tm //; rewrite ?es; move: qk n0; clear; lia.
Qed.
(* L3.10 as amended *)
Theorem L3_10_amended i : (2 <= k)%N -> Uopen t n k -> t n < t n.+1 -> (i.+2 <= n)%N -> Dleft k i (t m) = 0.
Proof.
move=> _ [e0 e1 e2] h im; rewrite Dleft_tmE; last by move: im; clear; lia.
have -> : s = n by apply: last_span_uniq => //; clear; lia.
have -> : (i == n) = false by apply/eqP; move: im; clear; lia.
have -> : (i.+1 == n) = false by apply/eqP; move: im; clear; lia.
by rewrite subrr mul0r.
Qed.
Lemma sum_dmw_tm : (0 < k)%N -> Uopen t n k -> 0 < \sum_(1 <= e < k.+1) dmw r t e s (t m).
Proof.
move=> k0 /last_open/andP[ks sn]; have p e : (1 <= e <= k)%N -> 0 < dmw r t e s (t m).
  by move=> he; apply: dmw_tm; move: he sn; clear; lia.
rewrite big_ltn // ltr_paddr ?p ?k0 // big_nat_cond; apply: sumr_ge0 => e /andP[he _].
by rewrite ltW // p //; move: he; clear; lia.
Qed.
(* L3.10 and the second line of T3.11.3b fail if the last knot occurs more than k+1 times *)
Theorem T3_11_3b_fails : (1 <= k)%N -> Uopen t n k -> t n = t n.+1 -> exists i, (i.+2 <= n)%N /\ Dleft k i (t m) != 0.
Proof.
move=> k0 ho h; have /andP[ks sn] := last_open ho.
have sn' : s != n by apply/eqP => e; move: s0; rewrite e h ltxx.
exists s.-1; split; first by move: k0 ks sn sn'; clear; lia.
rewrite Dleft_tmE; last by move: k0 ks sn; clear; lia.
have -> : (s.-1 == s) = false by apply/eqP; move: k0 ks; clear; lia.
have -> : (s.-1.+1 == s) by apply/eqP; move: k0 ks; clear; lia.
by rewrite sub0r mulN1r oppr_eq0 gt_eqF // sum_dmw_tm.
Qed.
End Last.
(* L3.10: not 0 for some i ≤ n−2 if t_n = t_{n+1} *)
Theorem L3_10_fails : (2 <= k)%N -> Uopen t n k -> t n = t n.+1 -> exists i, (i.+2 <= n)%N /\ Dleft k i (t m) != 0.
Proof. by move=> k2; apply: T3_11_3b_fails; exact: ltnW. Qed.

(* T3.11.2 as amended: limits and derivatives from both sides; from the right the limit is the value, from the left it is so
   at t_m and at multiplicity at most k *)
Theorem T3_11_2_amended i j : (i <= n)%N -> (j <= m)%N ->
  [/\ t 0%N < t j -> left_taylor (G k i) (t j) (limit_left k i (t j)) (Dleft k i (t j)),
      t j < t m -> right_taylor (G k i) (t j) (value k i (t j)) (Dright k i (t j)) &
      t 0%N < t j -> t j = t m \/ (mult t m (t j) <= k)%N -> limit_left k i (t j) = value k i (t j)].
Proof.
move=> im jm; split=> [h|h|h0 h].
- by apply: DleftP => //; rewrite h tle.
- by apply: DrightP => //; rewrite h tle.
case: (eqVneq (t j) (t m)) => [->|e]; first by rewrite /Values.limit_left left_span_tm // value_tm.
have hk : (mult t m (t j) <= k)%N by case: h => // e2; rewrite e2 eqxx in e.
have hj : t 0%N < t j < t m by rewrite h0 lt_neqAle e tle.
have [p [p1 p2 pm E]] := P3_1_2_paper r_gt0 t_mono i hj hk.
rewrite value_in ?E; last by case/andP: hj.
by rewrite /Values.limit_left (@left_span_uniq _ _ t_mono m _ p) // p1.
Qed.
(* T3.11.2: at an inner knot of multiplicity > k some function jumps *)
Theorem T3_11_2_fails j : (j <= m)%N -> t 0%N < t j < t m -> (k < mult t m (t j))%N ->
  exists i, (i <= n)%N /\ limit_left k i (t j) != value k i (t j).
Proof.
move=> jm hj hk; have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hj; set q := mult t m (t j) in hk p2 p3 p4 *.
have [h1 h2] := @P3_1_2_sharp _ (mw r t) t t_mono (mw_right r_gt0 (t:=t)) p q k (t j) p1 p2 p3 hk.
exists p; split; first by move: hk p4; clear; lia.
have pm : (p < m)%N by move: p4; clear; lia.
have e : t p.+1 = t j by apply: p2; move: hk; clear; lia.
rewrite /Values.limit_left (left_span_uniq t_mono (s := p)) //; last by rewrite p1 e lexx.
rewrite /P h1 value_in; last by case/andP: hj.
rewrite (G_P r t_mono _ _ (s := (p + q)%N)).
  by rewrite /P h2 oner_neq0.
by rewrite p3 andbT p2 //; move: hk; clear; lia.
Qed.

(* T3.11.3a as amended *)
Theorem T3_11_3a_amended : (1 <= k)%N -> Uopen t n k -> t k < t k.+1 ->
  [/\ Dright k 1 (t 0%N) = k%:R * r / (t k.+1 - t 0%N), Dright k 0 (t 0%N) = - (k%:R * r / (t k.+1 - t 0%N)) &
      forall i, (2 <= i <= n)%N -> Dright k i (t 0%N) = 0].
Proof.
move=> k1 [e0 e1 e2] h; have kn := Uopen_kn t_mono e2.
have km : (k < m)%N by move: kn; clear; lia.
have s1 : t 0%N < t k.+1 by rewrite e0.
have E i : Dright k i (t 0%N) = ((i == 1%N)%:R - (i == 0%N)%:R) * (k%:R * r / (t k.+1 - t 0%N)).
  by rewrite (Dright_t0 km (esym e0) s1) T3_11_3a_value // -mulrA.
rewrite !E /= subr0 sub0r mul1r mulN1r; split=> //.
by move=> [|[|i]] // _; rewrite E /= subr0 mul0r.
Qed.
(* and if the first knot occurs more often *)
Theorem T3_11_3a_fails : (1 <= k)%N -> Uopen t n k -> t k = t k.+1 -> exists i, (2 <= i <= n)%N /\ Dright k i (t 0%N) != 0.
Proof.
move=> k1 [e0 e1 e2] h; have [s [sm s0 s1]] := first_spanP t_mono U.
have ks : (k < s)%N by rewrite ltnNge; apply/negP => c; move: s1; rewrite ltNge e0 h tle.
have sn : (s <= n)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite s0 e0.
exists (s.+1 - k)%N; split; first by move: k1 ks sn; clear; lia.
rewrite (Dright_t0E sm s0 s1).
have -> : (s.+1 - k + k == s.+1)%N by apply/eqP; move: ks; clear; lia.
have -> : (s.+1 - k + k == s)%N = false by apply/eqP; move: ks; clear; lia.
have p e : (1 <= e <= k)%N -> 0 < dmw r t e (s.+1 - e) (t 0%N).
  by move=> he; apply: (dmw_t0 s0 s1); move: he ks; clear; lia.
rewrite subr0 mul1r gt_eqF // big_ltn // ltr_paddr ?p ?k1 // big_nat_cond; apply: sumr_ge0 => e /andP[he _].
by rewrite ltW // p //; move: he; clear; lia.
Qed.
(* T3.11.3b as amended *)
Theorem T3_11_3b_amended : (1 <= k)%N -> Uopen t n k -> t n < t n.+1 ->
  [/\ Dleft k n (t m) = k%:R / (r * (t m - t n)), Dleft k n.-1 (t m) = - (k%:R / (r * (t m - t n))) &
      forall i, (i.+2 <= n)%N -> Dleft k i (t m) = 0].
Proof.
move=> k1 [e0 e1 e2] h; have kn := Uopen_kn t_mono e2; have n0 : (0 < n)%N := leq_trans k1 kn.
have sn : last_span t m = n by apply: last_span_uniq => //; clear; lia.
have E i : (i <= n)%N -> Dleft k i (t m) = ((i == n)%:R - (i.+1 == n)%:R) * (k%:R / (r * (t m - t n))).
  by move=> im; rewrite Dleft_tm sn T3_11_3b_value // invfM.
split; first rewrite E ?leqnn //.
- by rewrite eqxx; have -> : (n.+1 == n) = false by [apply/eqP; clear; lia]; rewrite subr0 mul1r.
- rewrite E ?leq_pred // (ltn_predK n0) eqxx; have -> : (n.-1 == n) = false by apply/eqP; move: n0; clear; lia.
  by rewrite sub0r mulN1r.
move=> i im; rewrite E; last by move: im; clear; lia.
have -> : (i == n) = false by apply/eqP; move: im; clear; lia.
by have -> : (i.+1 == n) = false by [apply/eqP; move: im; clear; lia]; rewrite subrr mul0r.
Qed.

(* P3.1.1: rational on every span *)
Theorem P3_1_1_printed i j : (i <= n)%N -> (j < m)%N -> rational (t j) (t j.+1) (value k i).
Proof.
move=> im jm; have [f' h] := G_rational r_gt0 t_mono k i j; have [P [Q H]] := isd_rational h.
exists P, Q => x hx; have [q e] := H x hx; split => //.
by rewrite value_in // (lt_le_trans _ (tle jm)) //; case/andP: hx.
Qed.
(* T3.11.1: derivatives of every order on every span *)
Theorem T3_11_1_printed i j : (i <= n)%N -> (j < m)%N -> smooth (t j) (t j.+1) (value k i).
Proof. by move=> im jm; apply: rational_smooth; apply: P3_1_1_printed. Qed.

(* Rem3.1: simple knots, r <> 1, k >= 2: every G_i^k has a knot inside its support at which the derivative jumps *)
Theorem Rem3_1_printed i : (2 <= k)%N -> (forall j, (j < m)%N -> t j < t j.+1) -> (i <= n)%N -> r != 1 ->
  exists j, (i < j <= i + k)%N /\ Dleft k i (t j) != Dright k i (t j).
Proof.
move=> k2 simple im r1; exists i.+1; split; first by move: k2; clear; lia.
have i1 : (i.+1 < m)%N by move: im k2; clear; lia.
have hL : t i < t i.+1 by apply: simple; exact: ltnW.
have hR : t i.+1 < t i.+2 by apply: simple.
have hy j : (i < j <= i + 1)%N -> t j = t i.+1 by move=> h; congr (t _); move: h; clear; lia.
have hR1 : t i.+1 < t (i + 1).+1 by rewrite addn1.
have E : k = (2 + (k - 2))%N by move: k2; clear; lia.
rewrite /Values.Dleft /Values.Dright (@left_span_uniq _ _ t_mono m _ i) ?hL ?lexx ?(ltnW i1) //.
rewrite (@right_span_uniq _ _ t_mono m _ (i + 1)); [|by rewrite addn1|by rewrite hR1 addn1 lexx].
by rewrite E (jump_neq0 r_gt0 t_mono (isT : (0 < 1)%N) hL hy hR1).
Qed.
(* abstract.regularity for finite alpha: at a knot of multiplicity < k inside the derivative of some function jumps, r <> 1 or
   not being what decides; at multiplicity k, where only order 0 is asked for, no function jumps *)
Theorem abstract_regularity j : (2 * k <= m)%N -> t 0%N < t j < t m -> (mult t m (t j) <= k)%N ->
  ((mult t m (t j) < k)%N -> r != 1 -> exists i, (i <= n)%N /\ Dleft k i (t j) != Dright k i (t j)) /\
  (forall i, limit_left k i (t j) = value k i (t j)).
Proof.
move=> km hj hk; split=> [lt r1|i]; last first.
  have [p [p1 p2 pm E]] := P3_1_2_paper r_gt0 t_mono i hj hk.
  rewrite value_in ?E; last by case/andP: hj.
  by rewrite /Values.limit_left (@left_span_uniq _ _ t_mono m _ p) // p1.
have j0 : (0 < mult t m (t j))%N.
  rewrite /mult -has_count; apply/hasP; exists j; last exact: eqxx.
  by rewrite mem_iota /= ltnS ltnW // (t_lt_ltn t_mono) //; case/andP: hj.
have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hj; set q := mult t m (t j) in lt j0 p2 p3 p4 *.
have pm : (p < m)%N by move: p4; clear; lia.
have L : left_span t m (t j) = p.
  by apply: left_span_uniq => //; rewrite p1 p2 ?lexx //; move: j0; clear; lia.
have Rr : right_span t m (t j) = (p + q)%N.
  by apply: right_span_uniq => //; rewrite p3 p2 ?lexx //; move: j0; clear; lia.
have E : k = (q.+1 + (k - q.+1))%N by move: lt; clear; lia.
case: (leqP p n) => pn.
  have := jump_neq0 r_gt0 t_mono j0 p1 p2 p3 (k - q.+1); rewrite -E r1 => h.
  by exists p; rewrite /Values.Dleft /Values.Dright L Rr h.
have dp : (k - q.+1 < p)%N by move: km pn lt; clear; lia.
exists (p - (k - q.+1).+1)%N; split; first by move: p4 lt; clear; lia.
have := jump_low_neq0 r_gt0 t_mono j0 p1 p2 p3 dp; rewrite -E r1 => h.
by rewrite /Values.Dleft /Values.Dright L Rr h.
Qed.
End Statements.
