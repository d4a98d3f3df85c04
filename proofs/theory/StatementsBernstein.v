(* The claims about the Bernstein case (open knots, m = 2k+1), each as its stanza says it, for every degree. B_i^q on its own
   knots is G_(i+k-q)^q on those of degree k. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Bernstein Derivatives Jumps Values.
From Bsplines Require Import StatementsBasis StatementsDerivatives StatementsCurves.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Algebra.
Variable R : comRingType.
(* the derivative where all weights are one *)
Lemma dN_const (c c' : R) s d i : dN (fun _ _ => c) (fun _ _ => c') s d.+1 i =
  d.+1%:R * c' * (N (fun _ _ => c) s d i - N (fun _ _ => c) s d i.+1).
Proof.
elim: d i => [|d IH] i; first by rewrite dNS /= !mulr0; ring.
rewrite dNS !IH !NS -[d.+2]addn1 natrD.
move: (N _ s d i) (N _ s d i.+1) (N _ s d i.+2) (d.+1%:R : R) => a b e q; ring.
Qed.
End Algebra.

Section Bernstein.
Variable R : realFieldType.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable k : nat.
Local Notation m := (k + k.+1)%N.
Hypothesis B : Uopen t k k.
Let tle := t_le t_mono.
Let U : t 0%N < t m := Uopen_t0 B.

Lemma bern_left j : (j <= k)%N -> t j = t 0%N.
Proof. by case: B => e0 _ _ h; apply/eqP; rewrite eq_le {1}e0 !tle. Qed.
Lemma bern_right j : (k < j <= m)%N -> t j = t m.
Proof. by case: B => _ e1 _ /andP[h1 h2]; apply/eqP; rewrite eq_le -{2}e1 !tle. Qed.
Lemma bern_span x : t 0%N <= x < t m -> t k <= x < t k.+1.
Proof. by case: B => e0 e1 _; rewrite e0 e1. Qed.
Lemma bern_last : last_span t m = k.
Proof. by case: B => e0 e1 e2; apply: last_span_uniq => //; clear; lia. Qed.
(* on [t_0, t_m], the end with its limit, all weights are one *)
Lemma bern_value r q i x : (q <= k)%N -> t 0%N <= x <= t m -> value r t m q i x = N (fun _ _ => mob r x (t 0%N) (t m)) k q i.
Proof.
move=> qk /andP[x0 xm].
have E : P r t k q i x = N (fun _ _ => mob r x (t 0%N) (t m)) k q i.
  apply: N_ext => d j hj dq; rewrite /mw bern_left; last by case/andP: hj.
  by rewrite (@bern_right (j + d)%N) //; move: hj dq qk; clear; lia.
move: xm; rewrite le_eqVlt => /orP[/eqP e|h].
  by move: E; rewrite e value_tm bern_last.
by rewrite value_in // -E; apply: G_P => //; apply: bern_span; rewrite x0.
Qed.

Section Ratio.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Local Notation value := (value r t m).
Local Notation phi := (phi r).

Lemma bern_phi x : t 0%N <= x < t m -> phi x (t 0%N) (t m) = mob r x (t 0%N) (t m).
Proof. exact: phi_in. Qed.
(* P3.3.1 as amended *)
Theorem P3_3_1_amended i x : (1 <= k)%N -> (i <= k)%N -> t 0%N <= x < t m ->
  value k i x = phi x (t 0%N) (t m) * value k.-1 i x + (1 - phi x (t 0%N) (t m)) * value k.-1 i.+1 x.
Proof.
move=> k1 _ hx; have hx' : t 0%N <= x <= t m by have /andP[-> /ltW ->] := hx.
rewrite (bern_phi hx) !bern_value ?leq_pred //.
by case: k k1 => // d _; rewrite NS.
Qed.
(* P3.3.1 at t_m, where the weight is 0 by D2.3 *)
Theorem P3_3_1_fails i : (1 <= k)%N -> (k.-1 <= i <= k)%N ->
  value k i (t m) != phi (t m) (t 0%N) (t m) * value k.-1 i (t m) + (1 - phi (t m) (t 0%N) (t m)) * value k.-1 i.+1 (t m).
Proof.
move=> k1 hi; rewrite /Definitions.phi ltxx andbF mul0r add0r subr0 mul1r.
rewrite !value_tmE //; try (move: k1 hi; clear; lia).
rewrite bern_last; case: (eqVneq i k) => e.
  by have -> : (i.+1 == k) = false by [apply/eqP; move: e; clear; lia]; rewrite oner_neq0.
have -> : (i.+1 == k) by apply/eqP; move: hi e k1; clear; move=> ? /eqP; lia.
by rewrite eq_sym oner_neq0.
Qed.
(* P3.3.2 as amended *)
Lemma bern_closed i x : (i <= k)%N -> t 0%N <= x <= t m ->
  value k i x = 'C(k, i)%:R * mob r x (t 0%N) (t m) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i).
Proof.
move=> ik hx; rewrite bern_value // N_const // bin_sub //; congr (_ * _ ^+ _ * _).
by move: ik; clear; lia.
Qed.
(* P3.3.2: the closed form on [t_0, t_m) *)
Theorem P3_3_2_amended i x : (i <= k)%N -> t 0%N <= x < t m ->
  value k i x = 'C(k, i)%:R * phi x (t 0%N) (t m) ^+ i * (1 - phi x (t 0%N) (t m)) ^+ (k - i).
Proof. by move=> ik hx; rewrite bern_phi // bern_closed //; have /andP[-> /ltW ->] := hx. Qed.
(* P3.3.2: it fails at t_m for i = 0 and i = k *)
Theorem P3_3_2_fails i : (1 <= k)%N -> i = 0%N \/ i = k ->
  value k i (t m) != 'C(k, i)%:R * phi (t m) (t 0%N) (t m) ^+ i * (1 - phi (t m) (t 0%N) (t m)) ^+ (k - i).
Proof.
move=> k1 hi; rewrite /Definitions.phi ltxx andbF subr0 expr1n mulr1 value_tmE //; last by case: hi => ->; clear; lia.
rewrite bern_last; case: hi => ->.
  by rewrite (ltn_eqF k1) bin0 expr0 mulr1 eq_sym oner_neq0.
by rewrite eqxx expr0n (gtn_eqF k1) mulr0 oner_neq0.
Qed.
(* abstract.bezier.points as amended: as sets of points the curves are Bezier curves *)
Theorem abstract_bezier_points_amended (d : nat -> R) x : t 0%N <= x <= t m ->
  coordinate r t k k d x = \sum_(0 <= i < k.+1) d i * 'C(k, i)%:R * mob r x (t 0%N) (t m) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i).
Proof.
by move=> hx; apply: eq_big_nat => i /andP[_ ik]; rewrite bern_closed // !mulrA.
Qed.
(* X.derivative as amended: the derivative in the interval, from both sides *)
Theorem X_derivative_amended i x : (1 <= k)%N -> t 0%N < x < t m ->
  let D := k%:R * dmob r x (t 0%N) (t m) * (value k.-1 i x - value k.-1 i.+1 x) in
  left_taylor (G (wt r t) t k i) x (value k i x) D /\ right_taylor (G (wt r t) t k i) x (value k i x) D.
Proof.
move=> k1 hx D; have /andP[x0 xm] := hx; have hx' : t 0%N <= x < t m by rewrite ltW.
have hx2 : t 0%N <= x <= t m by rewrite !ltW.
have hs := bern_span hx'.
have V : value k i x = P r t k k i x by rewrite value_in // (G_P r t_mono _ _ hs).
have E : dP r t k k i x = D.
  have [_ ->] : N (fun d j => mw r t d j x) k k i = N (fun _ _ => mob r x (t 0%N) (t m)) k k i /\
     dP r t k k i x = dN (fun _ _ => mob r x (t 0%N) (t m)) (fun _ _ => dmob r x (t 0%N) (t m)) k k i.
    apply: dN_ext => d j _ hj dk; rewrite /mw /dmw bern_left; last by case/andP: hj.
    by rewrite (@bern_right (j + d)%N) //; move: hj dk; clear; lia.
  rewrite /D !bern_value ?leq_pred //; case: k k1 => // d _; exact: dN_const.
rewrite -E V; split; last exact: G_right.
by apply: G_left => //; have [e0 e1 _] := B; rewrite -e0 e1 x0 ltW.
Qed.
End Ratio.

(* abstract.bezier: B_0^k falls strictly as r rises *)
Theorem abstract_bezier r s x : (1 <= k)%N -> 0 < r -> 0 < s -> t 0%N < x < t m ->
  (value s t m k 0 x < value r t m k 0 x) = (r < s).
Proof.
move=> k1 r0 s0 /andP[x0 xm]; have hx : t 0%N <= x <= t m by rewrite !ltW.
rewrite !bern_closed // !bin0 !expr0 !mul1r subn0 !mob_compl ?ltW //.
have D q : 0 < q -> 0 < q * (x - t 0%N) + (t m - x) by move=> q0; rewrite mob_den_gt0 ?ltW.
have b0 : 0 < t m - x by rewrite subr_gt0.
have c q : 0 < q -> 0 <= (t m - x) / (q * (x - t 0%N) + (t m - x)) by move=> q0; rewrite divr_ge0 ?ltW ?D.
rewrite ltr_pexpn2r ?nnegrE ?c // ltr_pmul2l // ltf_pinv ?posrE ?D // ltr_add2r ltr_pmul2r //.
by rewrite subr_gt0.
Qed.
End Bernstein.
