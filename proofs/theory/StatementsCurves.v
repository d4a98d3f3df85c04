(* The claims about the Bernstein case, independence and curves (sections 3.2 and 4), each as its stanza says it, for every
   degree. A curve's coordinate is the sum of d_i value_i(x); d are the values of one coordinate of the control points. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Symmetry Bernstein Derivatives Independence Values.
From Bsplines Require Import StatementsBasis StatementsDerivatives.
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

(* D3.4, one coordinate *)
Definition coordinate (r : R) (t : nat -> R) n k (d : nat -> R) (x : R) : R :=
  \sum_(0 <= i < n.+1) d i * Values.value r t (n + k.+1) k i x.
Local Notation C := (coordinate r t n k).

Lemma im_deg i : (i <= n)%N -> (i + k < m)%N.
Proof. by clear; lia. Qed.
Lemma C_in d x : x < t m -> C d x = curve (V := [lmodType R of R^o]) (wt r t) t k n d x.
Proof. by move=> h; apply: eq_bigr => i _; rewrite value_in // [RHS]mulrC. Qed.
Lemma C_tm d : t n.+1 = t m -> C d (t m) = d (last_span t m).
Proof.
move=> e1; have [p1 p2 p3] := last_spanP t_mono U.
have sn : (last_span t m <= n)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite e1 -p3.
rewrite /coordinate (eq_big_nat _ _ (F2 := fun i => d i * (i == last_span t m)%:R)); last first.
  by move=> i /andP[_ hi]; rewrite value_tmE // im_deg.
rewrite (bigD1_seq (last_span t m)) ?mem_index_iota ?iota_uniq //= eqxx mulr1 big1 ?addr0 //.
by move=> i /negbTE ->; rewrite mulr0.
Qed.

(* P3.2: the only combination of the functions that is 0 on [t_0,t_m] is that with all factors 0 *)
Theorem P3_2_printed (c : nat -> R) : Uopen t n k -> Uinterior t n k ->
  (forall x, t 0%N <= x <= t m -> \sum_(0 <= i < n.+1) c i * value k i x = 0) -> forall i, (i <= n)%N -> c i = 0.
Proof.
move=> [e0 e1 e2] hi H; have kn := Uopen_kn t_mono e2.
have hk i : (i <= n)%N -> t i < t (i + k.+1)%N.
  move=> im; rewrite lt_neqAle tle ?leq_addr // andbT; apply/eqP => e.
  have E j : (i <= j <= i + k.+1)%N -> t j = t i.
    by move=> /andP[j1 j2]; apply/eqP; rewrite eq_le {1}e !tle.
  case: (leqP i k) => ik.
    (* t_k = t_(k+1) would be an interior knot of multiplicity > k, or t_(n+1) *)
    have ek : t k = t i by apply: E; move: ik; clear; lia.
    have ek1 : t k.+1 = t i by apply: E; move: ik; clear; lia.
    case: (ltnP k n) => kn'; last by move: e2; have -> : n = k by [apply/eqP; rewrite eqn_leq kn kn']; rewrite ek1 ek ltxx.
    have y0 : t k.+1 = t 0%N by rewrite ek1 -ek e0.
    have := hi k.+1; rewrite ltnSn kn' => /(_ isT); rewrite leqNgt => /negP; apply.
    rewrite /mult; have -> : (m.+1 = k.+2 + (m - k.+1))%N by move: kn'; clear; lia.
    rewrite iotaD count_cat (@eq_in_count _ _ predT (iota 0 _)); last first.
      move=> j; rewrite mem_iota => /andP[_ hj] /=; apply/eqP; apply/eqP; rewrite eq_le tle; last by move: hj; clear; lia.
      by rewrite y0 tle.
    by rewrite count_predT size_iota; exact: (leq_trans (leqnSn k.+1) (leq_addr _ _)).
  have := hi i; rewrite ik im => /(_ isT); rewrite leqNgt => /negP; apply.
  rewrite /mult; have -> : (m.+1 = i + (k.+2 + (m.+1 - i - k.+2)))%N by move: im; clear; lia.
  rewrite !iotaD !count_cat (@eq_in_count _ _ predT (iota (0 + i) k.+2)); last first.
    by move=> j; rewrite mem_iota => hj /=; rewrite E ?eqxx //; move: hj; clear; lia.
  rewrite count_predT size_iota; apply: leq_trans (leq_addl _ _).
  exact: (leq_trans (leqnSn k.+1) (leq_addr _ _)).
apply: (P3_2 r_gt0 t_mono hk) => x /andP[x0 x1].
rewrite -[RHS](H x); last by rewrite x0 ltW.
by apply: eq_bigr => i _; rewrite value_in.
Qed.

(* P4.1.1 as amended: d_j does not act outside of [t_j, t_(j+k+1)), but at t_m for the last function that is not 0 *)
Theorem P4_1_1_amended (d : nat -> R) j x : Uopen t n k -> (j <= n)%N -> t 0%N <= x <= t m ->
  ~~ (t j <= x < t (j + k.+1)%N) -> ~ (t j < t j.+1 /\ t j.+1 = x /\ x = t m) ->
  C d x = \sum_(0 <= i < j) d i * value k i x + \sum_(j.+1 <= i < n.+1) d i * value k i x.
Proof.
move=> _ jn _ h1 h2; rewrite /coordinate (big_cat_nat _ (n := j)) //=; last exact: leqW.
rewrite [X in _ + X = _]big_ltn //; have -> : value k j x = 0; last by rewrite mulr0 add0r.
apply: T3_5_1_amended => //.
- by apply: contra h1 => /andP[a b]; rewrite (ltW a).
- by move=> [e [e1 e2]]; case/negP: h1; rewrite e lexx /= e1.
by move=> [a [b c]]; exact: (h2 (conj a (conj (etrans b c) (esym c)))).
Qed.
(* P4.1.1 and P4.1.3's end: the exception *)
Theorem P4_1_1_fails (d : nat -> R) j : Uopen t n k -> (j <= n)%N -> t j < t j.+1 -> t j.+1 = t m -> C d (t m) = d j.
Proof.
move=> [e0 e1 e2] jn h1 h2; rewrite C_tm //; congr (d _).
by apply: last_span_uniq => //; move: jn; clear; lia.
Qed.
(* P4.1.2 *)
Theorem P4_1_2_printed (d : nat -> R) j x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  C d x = \sum_(j - k <= i < j.+1) d i * value k i x.
Proof.
move=> hj hx; have xm : x < t m by case/andP: hx => _ h; apply: (lt_le_trans h); apply: tle; move: hj; clear; lia.
rewrite C_in // (@P4_1_2 R (wt r t) t t_mono [lmodType R of R^o] k n j d x) //.
by apply: eq_bigr => i _; rewrite value_in // [RHS]mulrC.
Qed.
(* P4.1.4, the translation; linear maps commute with sums *)
Theorem P4_1_4_printed (d : nat -> R) (c : R) x : Uopen t n k -> t 0%N <= x <= t m ->
  C d x + c = \sum_(0 <= i < n.+1) (d i + c) * value k i x.
Proof.
move=> ho hx; have [_ s1] := P4_1_3_printed r_gt0 t_mono U ho hx.
rewrite (eq_bigr (fun i => d i * value k i x + c * value k i x)); last by move=> i _; rewrite mulrDl.
by rewrite big_split /= -mulr_sumr s1 mulr1.
Qed.
(* P4.2.1 as amended *)
Theorem P4_2_1_amended (d : nat -> R) : Uclamped t n k -> C d (t 0%N) = d 0%N /\ C d (t m) = d n.
Proof.
move=> hc; have [[e0 e1 e2] h1 h2] := hc; split; last first.
  by apply: P4_1_1_fails => //; split.
rewrite C_in // (@P4_2_1_left R (wt r t) t t_mono [lmodType R of R^o]) //; exact: wt_left.
Qed.
(* P4.2.1, end knots that occur p times more *)
Theorem P4_2_1_fails (d : nat -> R) p : Uopen t n k -> (1 <= p <= n)%N ->
  (t 0%N = t (k + p)%N -> t (k + p)%N < t (k + p).+1 -> C d (t 0%N) = d p) /\
  (t (n - p)%N < t (n - p).+1 -> t (n - p).+1 = t m -> C d (t m) = d (n - p)%N).
Proof.
move=> ho hp; split=> [h1 h2|h1 h2]; last by apply: P4_1_1_fails => //; exact: leq_subr.
have sp i : (i <= n)%N -> value k i (t 0%N) = (i == p)%:R.
  move=> im; rewrite value_in // (G_P r t_mono _ _ (s := (k + p)%N)); last by rewrite h1 lexx.
  rewrite /P /piece (@N_start _ _ (k + p)); first by congr (_%:R); rewrite addnC eqn_add2l.
  move=> e j /andP[a b]; have -> : t 0%N = t j by apply/eqP; rewrite eq_le tle // h1 tle.
  exact: mob_a.
rewrite /coordinate (eq_big_nat _ _ (F2 := fun i => d i * (i == p)%:R)); last first.
  by move=> i /andP[_ hi]; rewrite sp.
rewrite (bigD1_seq p) ?mem_index_iota ?iota_uniq //=; last by case/andP: hp => _ hp; rewrite ltnS.
by rewrite eqxx mulr1 big1 ?addr0 // => i /negbTE ->; rewrite mulr0.
Qed.

(* the one-sided expansions of the curve: its derivatives are the sums of those of the functions *)
Lemma sum_right (f : nat -> R -> R) (v l d : nat -> R) a x : (forall i, (i < a)%N -> right_taylor (f i) x (v i) (l i)) ->
  right_taylor (fun y => \sum_(0 <= i < a) d i * f i y) x (\sum_(0 <= i < a) d i * v i) (\sum_(0 <= i < a) d i * l i).
Proof.
elim: a => [|a IH] H.
  exists (fun _ => 0), 1; split; [exact: bnd_const|exact: ltr01|move=> h _; rewrite !big_geq //; ring].
have [|g [e [bg e0 hg]]] := IH; first by move=> i hi; apply: H; apply: leqW.
have [p [q [bp q0 hp]]] := H a (ltnSn a).
exists (fun h => g h + p h * d a), (Num.min e q); split.
- by apply: bnd_add => //; apply: bnd_mul => //; apply: bnd_const.
- by rewrite lt_minr e0.
move=> h /andP[h0]; rewrite lt_minr => /andP[h1 h2].
rewrite ![\sum_(0 <= i < a.+1) _]big_nat_recr //= hg ?h0 // hp ?h0 //.
move: (\sum_(0 <= i < a) d i * v i) (\sum_(0 <= i < a) d i * l i) => A A'.
move: (v a) (l a) (d a) (g h) (p h) => B B' c u u'; ring.
Qed.
Lemma sum_left (f : nat -> R -> R) (v l d : nat -> R) a x : (forall i, (i < a)%N -> left_taylor (f i) x (v i) (l i)) ->
  left_taylor (fun y => \sum_(0 <= i < a) d i * f i y) x (\sum_(0 <= i < a) d i * v i) (\sum_(0 <= i < a) d i * l i).
Proof.
elim: a => [|a IH] H.
  exists (fun _ => 0), 1; split; [exact: bnd_const|exact: ltr01|move=> h _; rewrite !big_geq //; ring].
have [|g [e [bg e0 hg]]] := IH; first by move=> i hi; apply: H; apply: leqW.
have [p [q [bp q0 hp]]] := H a (ltnSn a).
exists (fun h => g h + p h * d a), (Num.min e q); split.
- by apply: bnd_add => //; apply: bnd_mul => //; apply: bnd_const.
- by rewrite lt_minr e0.
move=> h /andP[h0]; rewrite lt_minr => /andP[h1 h2].
rewrite ![\sum_(0 <= i < a.+1) _]big_nat_recr //= hg ?h0 // hp ?h0 //.
move: (\sum_(0 <= i < a) d i * v i) (\sum_(0 <= i < a) d i * l i) => A A'.
move: (v a) (l a) (d a) (g h) (p h) => B B' c u u'; ring.
Qed.
Definition curve_in (d : nat -> R) x : R := \sum_(0 <= i < n.+1) d i * G k i x.
Lemma C_right d x : t 0%N <= x < t m -> right_taylor (curve_in d) x (C d x) (\sum_(0 <= i < n.+1) d i * Dright k i x).
Proof. by move=> h; apply: sum_right => i _; apply: DrightP. Qed.
Lemma C_left d x : t 0%N < x <= t m ->
  left_taylor (curve_in d) x (\sum_(0 <= i < n.+1) d i * limit_left r t m k i x) (\sum_(0 <= i < n.+1) d i * Dleft k i x).
Proof. by move=> h; apply: sum_left => i _; apply: DleftP. Qed.

Lemma two_terms (F d : nat -> R) a c : (a.+1 <= n)%N -> (forall i, (i <= n)%N -> F i = ((i == a.+1)%:R - (i == a)%:R) * c) ->
  \sum_(0 <= i < n.+1) d i * F i = c * (d a.+1 - d a).
Proof.
move=> an E; rewrite (eq_big_nat _ _ (F2 := fun i => d i * c * (i == a.+1)%:R - d i * c * (i == a)%:R)); last first.
  by move=> i /andP[_ hi]; rewrite E //; move: (_ == a.+1)%:R (_ == a)%:R => u v; ring.
have one b : (b <= n)%N -> \sum_(0 <= i < n.+1) d i * c * (i == b)%:R = d b * c.
  move=> bn; rewrite (bigD1_seq b) ?mem_index_iota ?iota_uniq //= eqxx mulr1 big1 ?addr0 //.
  by move=> i /negbTE ->; rewrite mulr0.
by rewrite sumrB !one //; [ring|exact: ltnW].
Qed.
(* P4.2.2 as amended, both ends: the expansions of the curve there *)
Theorem P4_2_2_amended (d : nat -> R) : (1 <= k)%N -> Uclamped t n k ->
  right_taylor (curve_in d) (t 0%N) (d 0%N) (k%:R * r / (t k.+1 - t 0%N) * (d 1%N - d 0%N)) /\
  left_taylor (curve_in d) (t m) (d n) (k%:R / (r * (t m - t n)) * (d n - d n.-1)).
Proof.
move=> k1 hc; have [ho h1 h2] := hc; have [e0 e1 e2] := ho; have kn := Uopen_kn t_mono e2.
have n0 : (0 < n)%N := leq_trans k1 kn.
have [c0 cm] := P4_2_1_amended d hc; split.
  have := C_right d (x := t 0%N); rewrite lexx U c0 => /(_ isT).
  rewrite (@two_terms _ _ 0 (k%:R * r / (t k.+1 - t 0%N))) // => i im.
  have [a1 a0 az] := T3_11_3a_amended r_gt0 t_mono k1 ho h1.
  case: i im => [|[|i]] im; rewrite ?a1 ?a0 ?az ?eqxx //=; last by rewrite subrr mul0r.
    by rewrite sub0r mulN1r.
  by rewrite subr0 mul1r.
have := C_left d (x := t m); rewrite lexx U => /(_ isT).
have -> : \sum_(0 <= i < n.+1) d i * limit_left r t m k i (t m) = d n.
  rewrite -cm; apply: eq_big_nat => i /andP[_ hi].
  by rewrite value_tm /limit_left left_span_tm.
rewrite (@two_terms _ _ n.-1 (k%:R / (r * (t m - t n)))) ?prednK // => i im.
have [a1 a0 az] := T3_11_3b_amended r_gt0 t_mono U k1 ho h2.
case: (eqVneq i n) => [->|en].
  rewrite a1; have -> : (n == n.-1) = false by apply/eqP; move: n0; clear; lia.
  by rewrite subr0 mul1r.
case: (eqVneq i n.-1) => [->|en1]; first by rewrite a0 sub0r mulN1r.
by rewrite az ?subrr ?mul0r //; move: im en en1 n0; clear; move=> ? /eqP ? /eqP; lia.
Qed.

(* P4.2.2, end knots that occur p times more *)
Theorem P4_2_2_fails (d : nat -> R) p : (1 <= k)%N -> Uopen t n k -> (1 <= p < n)%N ->
  (t 0%N = t (k + p)%N -> t (k + p)%N < t (k + p).+1 ->
     right_taylor (curve_in d) (t 0%N) (C d (t 0%N)) (k%:R * r / (t (k + p).+1 - t 0%N) * (d p.+1 - d p))) /\
  (t (n - p)%N < t (n - p).+1 -> t (n - p).+1 = t m ->
     left_taylor (curve_in d) (t m) (C d (t m)) (k%:R / (r * (t m - t (n - p)%N)) * (d (n - p)%N - d (n - p.+1)%N))).
Proof.
move=> k1 ho /andP[p1 pn]; split=> h1 h2.
  have s1 : t 0%N < t (k + p).+1 by rewrite h1.
  have sm : (k + p < m)%N by move: pn; clear; lia.
  have := C_right d (x := t 0%N); rewrite lexx U => /(_ isT).
  rewrite (@two_terms _ _ p (k%:R * r / (t (k + p).+1 - t 0%N))) // => i im.
  rewrite (Dright_t0E r t_mono sm (esym h1) s1) -addnS ![(k + _)%N]addnC !eqn_add2r; congr (_ * _).
  rewrite (eq_big_nat _ _ (F2 := fun _ => r / (t (p + k).+1 - t 0%N))).
    by rewrite sumr_const_nat subSS subn0 addSn -mulr_natl mulrA.
  move=> e he; rewrite /dmw (first_knots t_mono (esym h1)); last by move: he; clear; lia.
  have -> : ((p.+1 + k - e)%N + e = (p + k).+1)%N by move: he; clear; lia.
  by rewrite dmob_a // addnC.
have ls : last_span t m = (n - p)%N by apply: last_span_uniq => //; move: pn; clear; lia.
have := C_left d (x := t m); rewrite lexx U => /(_ isT).
have -> : \sum_(0 <= i < n.+1) d i * limit_left r t m k i (t m) = C d (t m).
  by apply: eq_big_nat => i /andP[_ hi]; rewrite value_tm /limit_left left_span_tm.
have np : (n - p = (n - p.+1).+1)%N by move: pn; clear; lia.
rewrite (@two_terms _ _ (n - p.+1) (k%:R / (r * (t m - t (n - p)%N)))); [by rewrite -np|by move: pn; clear; lia|].
move=> i im; rewrite (Dleft_tmE r_gt0 t_mono U); last exact: im_deg.
have -> : (i.+1 == last_span t m) = (i == n - p.+1)%N by rewrite ls np eqSS.
rewrite ls -np; congr (_ * _).
rewrite (eq_big_nat _ _ (F2 := fun _ => r^-1 / (t m - t (n - p)%N))).
  by rewrite sumr_const_nat subSS subn0 -mulr_natl invfM mulrA.
move=> e he; have E : t (n - p + e)%N = t m.
  by apply: (last_knots t_mono U); rewrite ls; move: he pn; clear; lia.
by rewrite /dmw E dmob_b // -h2.
Qed.

(* T4.1: de Boor's algorithm, all levels; b are its points *)
Definition b (d : nat -> R) q i x : R := deBoor (V := [lmodType R of R^o]) (wt r t) k d q i x.
Lemma b0 d i x : b d 0 i x = d i. Proof. by []. Qed.
Lemma bS d q i x : b d q.+1 i x = wt r t (k - q)%N i x * b d q i x + (1 - wt r t (k - q)%N i x) * b d q i.-1 x.
Proof. by []. Qed.
(* T4.1: all levels q ≤ k, and C = d_j^k *)
Theorem T4_1_printed (d : nat -> R) j x : (k <= j <= n)%N -> t j <= x < t j.+1 ->
  (forall q, (q <= k)%N -> C d x = \sum_(j - k + q <= i < j.+1) b d q i x * value (k - q) i x) /\ C d x = b d k j x.
Proof.
move=> hj hx; have xm : x < t m by case/andP: hx => _ h; apply: (lt_le_trans h); apply: tle; move: hj; clear; lia.
split=> [q hq|]; rewrite C_in //; last by apply: (@T4_1_last R (wt r t) t t_mono [lmodType R of R^o] k n j d x).
rewrite (@T4_1 R (wt r t) t t_mono [lmodType R of R^o] k n j d x q) //.
by apply: eq_bigr => i _; rewrite value_in // [RHS]mulrC.
Qed.
(* T4.1.range as amended *)
Theorem T4_1_range_amended (d : nat -> R) j q x : (1 <= k)%N -> Uopen t n k -> (k <= j <= n)%N -> (q < k)%N -> t j <= x < t j.+1 ->
  C d x = \sum_(j - k + q.+1 <= i < j.+1) b d q.+1 i x * value (k - q.+1) i x /\
  forall i, (j - k + q.+1 <= i <= j)%N ->
    b d q.+1 i x = wt r t (k - q)%N i x * b d q i x + (1 - wt r t (k - q)%N i x) * b d q i.-1 x.
Proof. by move=> _ _ hj hq hx; split; [have [H _] := T4_1_printed d hj hx; exact: H|move=> i _; exact: bS]. Qed.

(* P4.3 as amended: the curve for alpha at t_0+t_m-x is the curve of the points in reverse order for 1-alpha at x *)
Theorem P4_3_amended (d : nat -> R) x : Uopen t n k -> Usymmetric t n k -> t 0%N <= x <= t m ->
  x = t 0%N \/ x = t m \/ (mult t m x <= k)%N ->
  C d (t 0%N + t m - x) = \sum_(0 <= i < n.+1) d (n - i)%N * Values.value r^-1 t m k i x.
Proof.
move=> _ sym hx hk.
rewrite /coordinate [RHS]big_nat_rev /=; apply: eq_big_nat => i /andP[_ im].
by rewrite add0n subSS subKn // (T3_5_4_amended r_gt0 t_mono U sym im hx).
Qed.
(* P4.3: at an inner knot of multiplicity above k it fails for some G_i *)
Theorem P4_3_fails x : Uopen t n k -> Usymmetric t n k -> t 0%N < x < t m -> (k < mult t m x)%N ->
  exists i, (i <= n)%N /\ value k i (t 0%N + t m - x) != Values.value r^-1 t m k (n - i) x.
Proof. by move=> _; apply: T3_5_4_fails. Qed.
End Statements.
