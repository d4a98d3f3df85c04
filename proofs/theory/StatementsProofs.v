(* The claims about steps of the paper's proofs, the Bernstein case and the abstract, each as its stanza says it, for every degree. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Symmetry Bernstein Derivatives Independence Values.
From Bsplines Require Import StatementsBasis StatementsDerivatives StatementsCurves.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Proofs.
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

(* proof.T3.5.2.cover as amended *)
Theorem proof_T3_5_2_cover_amended i x : (1 <= k)%N -> ~ (t i < t i.+1 /\ t i.+1 = t (i + k)%N /\ t (i + k)%N < t (i + k.+1)%N) ->
  (t i < x < t (i + k)%N) || (t i.+1 < x < t (i + k.+1)%N) = (t i < x < t (i + k.+1)%N).
Proof.
move=> k1 h; have e1 : t i <= t i.+1 by []. have e2 : t (i + k)%N <= t (i + k.+1)%N by rewrite addnS.
have e3 : t i.+1 <= t (i + k)%N by apply: tle; move: k1; clear; lia.
apply/orP/andP => [[/andP[a b]|/andP[a b]]|[a b]].
- by rewrite a (lt_le_trans b e2).
- by rewrite (le_lt_trans e1 a) b.
case: (ltP x (t (i + k)%N)) => c; first by left; rewrite a.
right; rewrite b andbT; case: (ltP (t i.+1) x) => // d; case: h.
have E : t i.+1 = t (i + k)%N by apply/eqP; rewrite eq_le e3 (le_trans c d).
by split; [apply: (lt_le_trans a d)|split => //; apply: le_lt_trans c b].
Qed.
(* the exception: the knot t_(i+1) itself is missed, and nothing else *)
Theorem proof_T3_5_2_cover_fails i x : (1 <= k)%N -> t i < t i.+1 -> t i.+1 = t (i + k)%N -> t (i + k)%N < t (i + k.+1)%N ->
  (t i < x < t (i + k)%N) || (t i.+1 < x < t (i + k.+1)%N) = (t i < x < t (i + k.+1)%N) && (x != t i.+1).
Proof.
move=> k1 h1 h2 h3; rewrite -h2; case: (ltgtP x (t i.+1)) => c; rewrite ?andbT ?andbF ?orbF //=.
  by rewrite (lt_trans c _) ?andbT // h2.
by rewrite (lt_trans h1 c).
Qed.

(* proof.P4.1.1.iff as amended, and its exceptions *)
Theorem proof_P4_1_1_iff_amended j x : (j <= n)%N -> ~ (x = t j /\ t j = t (j + k)%N /\ t (j + k)%N < t (j + k.+1)%N) ->
  ~ (t j < t j.+1 /\ t j.+1 = t m /\ t m = x) -> (value k j x != 0) = (t j < x < t (j + k.+1)%N).
Proof.
move=> jn h1 h2; case: (boolP (t j < x < _)) => h; first by rewrite gt_eqF // T3_5_2_printed.
by rewrite (T3_5_1_amended r_gt0 t_mono U jn h h1 h2) eqxx.
Qed.
(* proof.P4.1.1.iff: 1 at these ends *)
Theorem proof_P4_1_1_iff_fails j x : (j <= n)%N ->
  (x = t j /\ t j = t (j + k)%N /\ t (j + k)%N < t (j + k.+1)%N) \/ (t j < t j.+1 /\ t j.+1 = t m /\ t m = x) -> value k j x = 1.
Proof. exact: T3_5_1_fails. Qed.

(* proof.T3.5.3.iff and proof.P4.1.2.iff as amended: which functions are not 0 at a point of a span *)
Theorem proof_T3_5_3_iff_amended j i x : (j < m)%N -> (i <= n)%N -> t j <= x < t j.+1 ->
  (value k i x != 0) = (j - k <= i <= j)%N && ((t j < x) || (t i < t j) || (i + k == j)%N).
Proof.
move=> jm im hx; have /andP[x1 x2] := hx.
have xm : x < t m by apply: (lt_le_trans x2); apply: tle.
rewrite value_in //; case: (boolP (i <= j <= i + k)%N) => hij; last first.
  rewrite (G_N t_mono _ _ _ hx) N_supp // eqxx; apply/esym/negbTE; move: hij; clear; lia.
have -> : (j - k <= i <= j)%N by move: hij; clear; lia.
have w0 := wt_left r t; have w1 := wt_range r_gt0 t; have wi : w_inside (wt r t) t by exact: wt_inside.
have xk : x < t (i + k.+1)%N by apply: (lt_le_trans x2); apply: tle; move: hij; clear; lia.
have ti : t i <= t j by apply: tle; case/andP: hij.
rewrite andTb; apply/idP/idP => [/(G_neq0_iff t_mono w0 w1 wi)|h].
  case=> [/andP[a _]|[a [b c]]].
    case: (ltP (t j) x) => //= d; have e : x = t j by apply/eqP; rewrite eq_le d x1.
    by rewrite -e a.
  have e : t j = t i by apply/eqP; rewrite eq_le ti -a x1.
  apply/orP; right; rewrite eqn_leq; apply/andP; split; last by case/andP: hij.
  by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite -b -e (le_lt_trans x1 x2).
apply/(G_neq0_iff t_mono w0 w1 wi); case: (ltP (t i) x) => c; first by left; rewrite xk.
have ex : x = t i by apply/eqP; rewrite eq_le c (le_trans ti x1).
have ej : t j = t i by apply/eqP; rewrite eq_le ti -ex x1.
move: h; rewrite -ex in ej *; rewrite ej ltxx /= => /eqP e; right; rewrite -e in ej x2.
by split => //; split; [rewrite ej|rewrite ej addnS].
Qed.
(* proof.T3.5.4.base: the case k = 0 is T3_5_4_amended, T3_5_4_fails. proof.T3.5.4.corollary as amended *)
Theorem proof_T3_5_4_corollary_amended i x : (1 <= k)%N -> Usymmetric t n k -> (i <= n.+1)%N -> t 0%N <= x <= t m -> mult t m x = 0%N ->
  phi r (t 0%N + t m - x) (t i) (t (i + k)%N) * value k.-1 i (t 0%N + t m - x) =
  (1 - phi r^-1 x (t (m - i - k)%N) (t (m - i)%N)) * Values.value r^-1 t m k.-1 (m - k - i) x.
Proof.
move=> k1 sym im /andP[x0 xm] hm.
have nk j : (j <= m)%N -> t j != x.
  move=> jm; apply/negP => e; have : has (fun i => t i == x) (iota 0 m.+1) by apply/hasP; exists j => //; rewrite mem_iota.
  by rewrite has_count -/(mult t m x) hm.
have hx : t 0%N < x < t m by rewrite !lt_neqAle x0 xm nk // eq_sym nk.
have ek : k = k.-1.+1 by rewrite prednK.
have em : m = (n.+1 + k.-1.+1)%N by move: ek; clear; lia.
have sym' : forall j, (j <= n.+1 + k.-1.+1)%N -> t (n.+1 + k.-1.+1 - j)%N = t 0%N + t (n.+1 + k.-1.+1)%N - t j by rewrite -em.
have eG : value k.-1 i (t 0%N + t m - x) = Values.value r^-1 t m k.-1 (m - k - i) x.
  have /andP[hx1 hx2] := hx.
  rewrite !value_in // ?ltr_subl_addr ?[_ + x]addrC ?ltr_add2r //.
  have -> : (m - k - i = n.+1 - i)%N by move: im; clear; lia.
  have := @T3_5_4 R r r_gt0 t t_mono n.+1 k.-1 sym' i x im; rewrite -em; apply => //.
  by rewrite hm.
rewrite eG; case: (boolP (t (m - i - k)%N < x < t (m - i)%N)) => h.
  have h' : t 0%N + t m - t (i + k)%N < x < t 0%N + t m - t i.
    rewrite -!sym; try (move: im; clear; lia).
    by have <- : (m - i - k = m - (i + k))%N by move: im; clear; lia.
  have := C2_4 r_gt0 h'; rewrite -!sym; try (move: im; clear; lia).
  by have <- : (m - i - k = m - (i + k))%N by [move: im; clear; lia]; move=> ->.
have ea : (m - k - i + k.-1.+1 = m - i)%N by move: k1 im; clear; lia.
have eb : (m - i - k = m - k - i)%N by clear; lia.
have -> : Values.value r^-1 t m k.-1 (m - k - i) x = 0; last by rewrite !mulr0.
rewrite value_in; last by case/andP: hx.
rewrite T3_5_1_outside // ea; apply: contra h => /andP[a b].
by rewrite eb lt_neqAle nk ?a ?b //; move: im; clear; lia.
Qed.

(* proof.P3.2.hypothesis as amended: of degree k-1 the first and the last function are 0, the n others independent *)
Theorem proof_P3_2_hypothesis_amended : (2 <= k)%N -> Uopen t n k -> Uinterior t n k ->
  (forall x, t 0%N <= x <= t m -> value k.-1 0 x = 0 /\ value k.-1 n.+1 x = 0) /\
  (forall c : nat -> R, (forall x, t 0%N <= x <= t m -> \sum_(1 <= i < n.+1) c i * value k.-1 i x = 0) ->
     forall i, (1 <= i <= n)%N -> c i = 0).
Proof.
move=> k2 [e0 e1 e2] hi; have inner := Uinterior_inner t_mono e2 hi.
have ek : k.-1.+1 = k by move: k2; clear; lia.
have en : (n.+1 + k = m)%N by clear; lia.
have kn := Uopen_kn t_mono e2; split.
  move=> x /andP[x0 xm]; case: (ltP x (t m)) => h.
    rewrite !value_in // !T3_5_1_outside //; first by rewrite negb_and -leNgt -ltNge ek en -e1 ltNge; case: (ltP x (t n.+1)).
    by rewrite negb_and -leNgt -ltNge add0n ek -e0 x0 orbT.
  have -> : x = t m by apply/eqP; rewrite eq_le xm h.
  have [p1 p2 p3] := last_spanP t_mono U.
  rewrite !value_tmE //; try (move: k2; clear; lia).
  have -> : (0 == last_span t m)%N = false.
    by apply/eqP => e; move: U; rewrite ltNge -p3 -e e0 tle //; move: k2; clear; lia.
  have -> : (n.+1 == last_span t m) = false by apply/eqP => e; move: p2; rewrite p3 -e e1 ltxx.
  by [].
move=> c H i hin; pose t' j := t j.+1; have mono' j : t' j <= t' j.+1 by exact: t_mono.
have hk j : (j <= n.-1)%N -> t' j < t' (j + k.-1.+1)%N.
  move=> jn; rewrite /t' ek lt_neqAle tle ?andbT; last by clear; lia.
  apply/eqP => e; have E l : (j < l <= (j + k).+1)%N -> t l = t j.+1.
    by move=> /andP[l1 l2]; apply/eqP; rewrite eq_le {1}e !tle.
  have y0 : t 0%N <= t j.+1 by exact: tle.
  have ym : t j.+1 <= t m by apply: tle; move: jn hin; clear; lia.
  case: (eqVneq (t j.+1) (t 0%N)) => ne0.
    have : t k.+1 = t 0%N.
      apply/eqP; rewrite eq_le [X in _ && X]tle // andbT -ne0 -(E (j + k).+1) ?tle //; move: k2; clear; lia.
    case: (ltnP k n) => kn' h0; last by move: e2; have -> : n = k by [apply/eqP; rewrite eqn_leq kn kn']; rewrite h0 e0 ltxx.
    have := hi k.+1; rewrite ltnSn kn' => /(_ isT); rewrite leqNgt => /negP; apply.
    rewrite /mult; have -> : (m.+1 = k.+2 + (m - k.+1))%N by move: kn'; clear; lia.
    rewrite iotaD count_cat (@eq_in_count _ _ predT (iota 0 _)); last first.
      move=> l; rewrite mem_iota => /andP[_ hl] /=; apply/eqP; apply/eqP; rewrite eq_le tle; last by move: hl; clear; lia.
      by rewrite h0 tle.
    by rewrite count_predT size_iota; exact: (leq_trans (leqnSn k.+1) (leq_addr _ _)).
  case: (eqVneq (t j.+1) (t m)) => nem.
    have tn : t n = t m.
      apply/eqP; rewrite eq_le tle /=; last by clear; lia.
      by rewrite -nem tle //; move: jn hin; clear; lia.
    case: (ltnP k n) => kn'; last first.
      have nk : n = k by apply/eqP; rewrite eqn_leq kn kn'.
      by move: e2; rewrite e1 -tn -nk; rewrite ltxx.
    have := hi n; rewrite kn' leqnn tn => /(_ isT); rewrite leqNgt => /negP; apply.
    rewrite /mult; have -> : (m.+1 = n + k.+2)%N by clear; lia.
    rewrite iotaD count_cat (@eq_in_count _ _ predT (iota (0 + n) _)); last first.
      move=> l; rewrite mem_iota => /andP[hl1 hl2] /=; apply/eqP; apply/eqP; rewrite eq_le tle; last by move: hl2; clear; lia.
      by rewrite -tn tle.
    by rewrite count_predT size_iota; apply: leq_trans (leq_addl _ _).
  have hy : t 0%N < t j.+1 < t m by rewrite !lt_neqAle eq_sym ne0 nem y0 ym.
  have := inner _ hy; rewrite leqNgt => /negP; apply.
  rewrite /mult; have -> : (m.+1 = j.+1 + (k.+1 + (m.+1 - j.+1 - k.+1)))%N by move: jn hin; clear; lia.
  rewrite !iotaD !count_cat (@eq_in_count _ _ predT (iota (0 + j.+1) k.+1)); last first.
    by move=> l; rewrite mem_iota => hl /=; rewrite E ?eqxx //; move: hl; clear; lia.
  by rewrite count_predT size_iota; apply: leq_trans (leq_addl _ _); exact: leq_addr.
have shift j x : G (wt r t') t' k.-1 j x = G (wt r t) t k.-1 j.+1 x.
  elim: (k.-1) j => [|d IH] j; first by rewrite !G0.
  by rewrite !GS !IH /wt /t' -!addSn.
have hn : (n.-1 + k.-1.+1 = m - 2)%N by move: k2 hin; clear; lia.
have := @P3_2 R r r_gt0 t' mono' k.-1 n.-1 (fun j => c j.+1) hk _ i.-1.
have -> : i.-1.+1 = i by move: hin; clear; lia.
apply; last by move: hin; clear; lia.
move=> x; rewrite hn /t'; have -> : ((m - 2).+1 = n + k)%N by move: k2; clear; lia.
move=> /andP[a b].
have xm : x < t m by apply: (lt_le_trans b); apply: tle; clear; lia.
rewrite -[RHS](H x); last by rewrite (le_trans (tle (leq0n 1)) a) ltW.
rewrite [RHS]big_add1 /=; have -> : n.-1.+1 = n by move: hin; clear; lia.
by apply: eq_bigr => j _; rewrite shift value_in.
Qed.

(* proof.P4.3.bisector as amended *)
Theorem proof_P4_3_bisector_amended (d : nat -> R) : Uopen t n k -> Usymmetric t n k -> Uinterior t n k ->
  (forall x, t 0%N <= x <= t m -> coordinate r^-1 t n k d x = \sum_(0 <= i < n.+1) d (n - i)%N * value k i (t 0%N + t m - x)) /\
  (forall c : nat -> R, (forall x, t 0%N <= x <= t m -> \sum_(0 <= i < n.+1) c i * value k i x = 0) -> forall i, (i <= n)%N -> c i = 0).
Proof.
move=> ho sym hi; split; last by move=> c H; exact: (P3_2_printed r_gt0 t_mono ho hi H).
move=> x hx; have [e0 e1 e2] := ho; rewrite /coordinate [RHS]big_nat_rev /=; apply: eq_big_nat => i /andP[_ im].
rewrite add0n subSS subKn //; congr (_ * _).
rewrite (T3_5_4_amended r_gt0 t_mono U sym (leq_subr _ _) hx) ?subKn //.
case: (eqVneq x (t 0%N)) => [|n0]; first by left.
case: (eqVneq x (t m)) => [|n1]; first by right; left.
right; right; apply: (Uinterior_inner t_mono e2 hi).
by case/andP: hx => h1 h2; rewrite !lt_neqAle eq_sym n0 n1 h1 h2.
Qed.

(* abstract.approx: the three formulas of its core *)
Theorem abstract_approx_printed x : Uopen t n k -> t 0%N <= x <= t m ->
  [/\ \sum_(0 <= i < n.+1) value k i x = 1, forall i, (i <= n)%N -> 0 <= value k i x &
      forall i h, (i <= n)%N -> (forall j, (j < m)%N -> t j.+1 - t j <= h) -> value k i x != 0 ->
        Num.max (x - t i) (t (i + k.+1)%N - x) <= k.+1%:R * h].
Proof.
move=> ho hx; have [h1 h2] := P4_1_3_printed r_gt0 t_mono U ho hx; split => // i h im hh nz.
have gaps d : (i + d <= m)%N -> t (i + d)%N - t i <= d%:R * h.
  elim: d => [|d IH] le; first by rewrite addn0 subrr mul0r.
  have le1 : (i + d < m)%N by rewrite -addnS.
  have -> : t (i + d.+1)%N - t i = (t (i + d)%N - t i) + (t (i + d).+1 - t (i + d)%N) by rewrite addnS; ring.
  by rewrite -[X in X%:R]addn1 natrD mulrDl mul1r; apply: ler_add; [apply: IH; exact: ltnW|exact: hh].
have w : t (i + k.+1)%N - t i <= k.+1%:R * h by apply: gaps; rewrite leq_add2r.
have /andP[a b] : t i <= x <= t (i + k.+1)%N.
  case: (boolP (t i <= x <= t (i + k.+1)%N)) => // c; move: nz; case: (ltgtP x (t m)) => xm.
  - rewrite value_in // T3_5_1_outside ?eqxx //; apply: contra c => /andP[-> /ltW ->] //.
  - by rewrite value_out ?eqxx.
  rewrite xm value_tmE //; last by rewrite -addSnnS ltnS leq_add2r.
  case: (eqVneq i _) => [e _|_]; last by rewrite eqxx.
  have [p1 p2 p3] := last_spanP t_mono U; case/negP: c; rewrite -e in p2 p3.
  by rewrite xm -p3 (ltW p2) tle //; clear; lia.
by rewrite le_maxl !(le_trans _ w) // ?ler_add2l ?ler_add2r // ler_opp2.
Qed.
End Proofs.
