(* The paper's definitions D3.3 and D3.4 and the points of T4.1, over any ordered field, for any weight family. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- a piece: the recursion run with the span's index s fixed; weights are any numbers w d i (degree, index) ---- *)
Section Piece.
Variable R : comRingType.
Implicit Type w : nat -> nat -> R.

Fixpoint N w (s k i : nat) : R :=
  if k is d.+1 then w d.+1 i * N w s d i + (1 - w d.+1 i.+1) * N w s d i.+1
  else (i == s)%:R.

Lemma NS w s d i : N w s d.+1 i = w d.+1 i * N w s d i + (1 - w d.+1 i.+1) * N w s d i.+1.
Proof. by []. Qed.

Lemma N_supp w s k i : ~~ (i <= s <= i + k)%N -> N w s k i = 0.
Proof.
elim: k i => [|k IH] i h /=.
  by case: eqP => // e; move: h; rewrite e addn0 leqnn.
by rewrite !IH ?mulr0 ?addr0 //; apply: contra h; lia.
Qed.

(* only the weights of intervals that contain the span matter *)
Lemma N_ext w w' s k i : (forall d j, (j <= s < j + d)%N -> (d <= k)%N -> w d j = w' d j) -> N w s k i = N w' s k i.
Proof.
elim: k i => [|k IH] i h //; rewrite !NS.
have hk d j : (j <= s < j + d)%N -> (d <= k)%N -> w d j = w' d j by move=> ? ?; apply: h; lia.
rewrite -!(IH _ hk); congr (_ + _).
  case: (boolP (i <= s <= i + k)%N) => e; last by rewrite N_supp // !mulr0.
  by rewrite (h _ i) //; lia.
case: (boolP (i.+1 <= s <= i.+1 + k)%N) => e; last by rewrite N_supp // !mulr0.
by rewrite (h _ i.+1) //; lia.
Qed.

(* de Boor's step, one level, with vectors *)
Variable V : lmodType R.
Lemma N_step w s k (u : nat -> V) : (k < s.+1)%N -> (0 < k)%N ->
  \sum_(s - k <= i < s.+1) N w s k i *: u i =
  \sum_((s - k).+1 <= i < s.+1) N w s k.-1 i *: (w k i *: u i + (1 - w k i) *: u i.-1).
Proof.
case: k => // k ks _; rewrite [k.+1.-1]/=.
rewrite (eq_bigr (fun i => (w k.+1 i * N w s k i) *: u i + ((1 - w k.+1 i.+1) * N w s k i.+1) *: u i)); last first.
  by move=> i _; rewrite NS scalerDl.
rewrite big_split /=.
have -> : \sum_(s - k.+1 <= i < s.+1) (w k.+1 i * N w s k i) *: u i =
          \sum_((s - k.+1).+1 <= i < s.+1) (w k.+1 i * N w s k i) *: u i.
  rewrite big_ltn ?N_supp ?mulr0 ?scale0r ?add0r //; lia.
have -> : \sum_(s - k.+1 <= i < s.+1) ((1 - w k.+1 i.+1) * N w s k i.+1) *: u i =
          \sum_((s - k.+1).+1 <= i < s.+1) ((1 - w k.+1 i) * N w s k i) *: u i.-1.
  rewrite [RHS]big_add1 /= big_nat_recr /=; last lia.
  by rewrite N_supp ?mulr0 ?scale0r ?addr0 //; lia.
rewrite -big_split /=; apply: eq_bigr => i _.
by rewrite scalerDr !scalerA; congr (_ *: _ + _ *: _); rewrite mulrC.
Qed.

(* de Boor's points (T4.1): d_i^{q+1} = w_i^{k-q} d_i^q + (1 - w_i^{k-q}) d_{i-1}^q *)
Fixpoint dB w (k : nat) (u : nat -> V) (q i : nat) : V :=
  if q is p.+1 then w (k - p)%N i *: dB w k u p i + (1 - w (k - p)%N i) *: dB w k u p i.-1 else u i.

(* de Boor's algorithm on a span, q levels, any numbers as weights *)
Theorem N_deBoor w s k (u : nat -> V) q : (k <= s)%N -> (q <= k)%N ->
  \sum_(s - k <= i < s.+1) N w s k i *: u i = \sum_(s - k + q <= i < s.+1) N w s (k - q) i *: dB w k u q i.
Proof.
move=> ks; elim: q => [|q IH] qk; first by rewrite addn0 subn0.
rewrite IH; last lia.
have -> : (s - k + q = s - (k - q))%N by lia.
rewrite N_step; try lia.
have -> : ((s - (k - q)).+1 = s - k + q.+1)%N by lia.
by have -> : ((k - q).-1 = k - q.+1)%N by lia.
Qed.

(* and all levels: one point is left *)
Theorem N_deBoor_last w s k (u : nat -> V) : (k <= s)%N ->
  \sum_(s - k <= i < s.+1) N w s k i *: u i = dB w k u k s.
Proof.
move=> ks; rewrite (@N_deBoor w s k u k) // subnn subnK // big_nat1 /= eqxx scale1r //.
Qed.
End Piece.

(* the functions of a span have the sum 1, any numbers as weights *)
Theorem N_sum1 (R : comRingType) (w : nat -> nat -> R) s k : (k <= s)%N -> \sum_(s - k <= i < s.+1) N w s k i = 1.
Proof.
move=> ks; pose u := fun _ : nat => (1 : R^o).
have h q i : dB w k u q i = 1.
  elim: q i => // q IH i /=; rewrite !IH /GRing.scale /= !mulr1; ring.
transitivity (\sum_(s - k <= i < s.+1) N w s k i *: u i).
  by apply: eq_bigr => i _; rewrite /GRing.scale /= mulr1.
by rewrite N_deBoor_last // h.
Qed.

(* ---- the paper's objects ---- *)
Section Defs.
Variable R : realFieldType.

(* D2.3, in r-form and as printed *)
Definition mob (r x a b : R) : R := r * (x - a) / (r * (x - a) + (b - x)).
Definition phi (r x a b : R) : R := if a <= x < b then mob r x a b else 0.
Definition f_alpha (al x a b : R) : R := al * (x - a) / (x + (al - 1) * b - al * a).
Definition phi_alpha (al x a b : R) : R := if a <= x < b then f_alpha al x a b else 0.

(* D3.3, for a general weight family w d i x *)
Fixpoint G (w : nat -> nat -> R -> R) (t : nat -> R) (k i : nat) (x : R) : R :=
  if k is d.+1 then w d.+1 i x * G w t d i x + (1 - w d.+1 i.+1 x) * G w t d i.+1 x
  else if t i <= x < t i.+1 then 1 else 0.

(* the paper's weights on knots t *)
Definition wt (r : R) (t : nat -> R) (d i : nat) (x : R) : R := phi r x (t i) (t (i + d)%N).
Definition wt_alpha (al : R) (t : nat -> R) (d i : nat) (x : R) : R := phi_alpha al x (t i) (t (i + d)%N).

(* D3.4 *)
Definition curve (V : lmodType R) w t k n (d : nat -> V) (x : R) : V := \sum_(0 <= i < n.+1) G w t k i x *: d i.

Lemma G0 w t i x : G w t 0 i x = if t i <= x < t i.+1 then 1 else 0. Proof. by []. Qed.
Lemma GS w t d i x : G w t d.+1 i x = w d.+1 i x * G w t d i x + (1 - w d.+1 i.+1 x) * G w t d i.+1 x.
Proof. by []. Qed.

Lemma eq_G (w w' : nat -> nat -> R -> R) t k i x : (forall d j, w d j x = w' d j x) -> G w t k i x = G w' t k i x.
Proof. by move=> h; elim: k i => // k IH i; rewrite !GS !h !IH. Qed.

(* knots *)
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Lemma t_le i j : (i <= j)%N -> t i <= t j.
Proof. by apply: (homo_leq (f := t) (r := fun a b => a <= b)) => // y x z; apply: le_trans. Qed.
Lemma t_lt_ltn i j : t i < t j -> (i < j)%N.
Proof. by move=> h; rewrite ltnNge; apply/negP => /t_le; rewrite leNgt h. Qed.

Lemma span_eq s i x : t s <= x < t s.+1 -> (t i <= x < t i.+1) = (i == s).
Proof.
move=> /andP[h1 h2]; case: (ltngtP i s) => [h|h|->]; last by rewrite h1 h2.
  by rewrite [x < _]ltNge (le_trans (t_le h) h1) andbF.
by rewrite [_ <= x]leNgt (lt_le_trans h2 (t_le h)).
Qed.

(* on a span G is the piece *)
Lemma G_N w s k i x : t s <= x < t s.+1 -> G w t k i x = N (fun d j => w d j x) s k i.
Proof.
move=> h; elim: k i => [|k IH] i; last by rewrite GS NS !IH.
by rewrite /= (span_eq i h); case: (i == s).
Qed.

(* every x of [t_i, t_j) lies in a span *)
Lemma span_exists i j x : t i <= x < t j -> exists s, (i <= s < j)%N /\ t s <= x < t s.+1.
Proof.
elim: j => [|j IH] /andP[h1 h2].
  by have := t_le (leq0n i); rewrite leNgt (le_lt_trans h1 h2).
case: (ltP x (t j)) => h; last first.
  exists j; split; last by rewrite h h2.
  by rewrite ltnSn andbT; have := t_lt_ltn (le_lt_trans h1 h2); rewrite ltnS.
by have [|s [hs1 hs2]] := IH; [rewrite h1 h|exists s; split => //; move: hs1; lia].
Qed.
End Defs.
