(* X.nurbs: on every span the functions are rational Bézier curves of degree k(k+1)/2 with one set of positive weights. The product of the
   denominators of all weights over the span is such a polynomial, and each function times it is one of that degree. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Bezier.
Variable R : realFieldType.
Variables a b : R.
(* sums of c_l (x-a)^l (b-x)^(D-l), l = 0, .., D *)
Definition mono D l (x : R) : R := (x - a) ^+ l * (b - x) ^+ (D - l).
Definition bez D (c : nat -> R) (f : R -> R) := forall x, f x = \sum_(0 <= l < D.+1) c l * mono D l x.
Definition bezier D f := exists c, bez D c f.
Definition positive D f := exists2 c, bez D c f & forall l, (l <= D)%N -> 0 < c l.
Definition step D p q (c : nat -> R) l : R := (if l is l'.+1 then p * c l' else 0) + (if (l <= D)%N then q * c l else 0).
Lemma bez_step D p q c f : bez D c f -> bez D.+1 (step D p q c) (fun x => (p * (x - a) + q * (b - x)) * f x).
Proof.
move=> h x; rewrite h /step [RHS](eq_bigr (fun l => (if l is l'.+1 then p * c l' else 0) * mono D.+1 l x + (if (l <= D)%N then q * c l else 0) * mono D.+1 l x)); last first.
  by move=> l _; rewrite mulrDl.
rewrite big_split /= mulrDl; congr (_ + _).
  rewrite [RHS]big_nat_recl //= mul0r add0r mulr_sumr; apply: eq_big_nat => l _.
  by rewrite /mono subSS exprS; move: ((x - a) ^+ l) ((b - x) ^+ (D - l)) => u v; ring.
rewrite [RHS]big_nat_recr //= ltnn mul0r addr0 mulr_sumr; apply: eq_big_nat => l /andP[_ hl].
by rewrite ltnS in hl; rewrite hl /mono subSn // exprS; move: ((x - a) ^+ l) ((b - x) ^+ (D - l)) => u v; ring.
Qed.
Definition linear (f : R -> R) := exists p q, forall x, f x = p * (x - a) + q * (b - x).
Lemma bezier_lin D f g : linear f -> bezier D g -> bezier D.+1 (fun x => f x * g x).
Proof. by move=> [p [q e]] [c h]; exists (step D p q c) => x; rewrite e; exact: bez_step h x. Qed.
Lemma bezier_prod D d (f : nat -> R -> R) g : (forall e, (e < d)%N -> linear (f e)) -> bezier D g -> bezier (d + D) (fun x => (\prod_(0 <= e < d) f e x) * g x).
Proof.
elim: d => [|d IH] hf hg.
  by have [c h] := hg; exists c => x; rewrite big_geq // mul1r.
have [c h] := bezier_lin (hf d (ltnSn d)) (IH (fun e he => hf e (leqW he)) hg).
by exists c => x; rewrite -h big_nat_recr //= mulrAC mulrC mulrA.
Qed.
Lemma bezier_add D f g : bezier D f -> bezier D g -> bezier D (fun x => f x + g x).
Proof. by move=> [c h] [c' h']; exists (fun l => c l + c' l) => x; rewrite h h' -big_split; apply: eq_bigr => l _; rewrite mulrDl. Qed.
Lemma bezier_0 D : bezier D (fun _ => 0).
Proof. by exists (fun _ => 0) => x; rewrite big1 // => l _; rewrite mul0r. Qed.
Lemma bezier_ext D f g : (forall x, f x = g x) -> bezier D f -> bezier D g.
Proof. by move=> e [c h]; exists c => x; rewrite -e. Qed.
Lemma positive_lin D p q g : 0 < p -> 0 < q -> positive D g -> positive D.+1 (fun x => (p * (x - a) + q * (b - x)) * g x).
Proof.
move=> p0 q0 [c h c0]; exists (step D p q c); first exact: bez_step.
move=> [|l] hl; rewrite /step /=; first by rewrite add0r mulr_gt0 // c0.
by rewrite ltr_paddr ?mulr_gt0 ?c0 //; case: ifP => // h'; rewrite mulr_ge0 ?(ltW q0) // ltW // c0.
Qed.
End Bezier.

Section Span.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variable s : nat.
Hypothesis ss : t s < t s.+1.
Local Notation a := (t s).
Local Notation b := (t s.+1).
Local Notation bezier := (bezier a b).
Local Notation linear := (linear a b).
Let ba : b - a != 0. Proof. by rewrite gt_eqF // subr_gt0. Qed.
(* a linear function by its values at the ends *)
Lemma linear_ends (f : R -> R) p q : (forall x, f x = p * x + q) -> forall x, f x = f b / (b - a) * (x - a) + f a / (b - a) * (b - x).
Proof. by move=> e x; rewrite !e; field. Qed.
Lemma linear_of (f : R -> R) p q : (forall x, f x = p * x + q) -> linear f.
Proof. by move=> e; exists (f b / (b - a)), (f a / (b - a)); exact: linear_ends e. Qed.
(* the denominators of the d weights of degree d over the span *)
Definition Ld d e (x : R) : R := r * (x - t (s - e)%N) + (t (s - e + d)%N - x).
Lemma Ld_lin d e x : Ld d e x = (r - 1) * x + (t (s - e + d)%N - r * t (s - e)%N).
Proof. by rewrite /Ld; ring. Qed.
Lemma Ld_gt0 d e x : (e < d)%N -> a <= x <= b -> 0 < Ld d e x.
Proof.
move=> ed /andP[x1 x2]; have h1 : (s - e <= s)%N by exact: leq_subr. have h2 : (s.+1 <= s - e + d)%N by move: ed; clear; lia.
apply: mob_den_gt0 => //; [exact: le_trans (tle h1) x1|exact: le_trans x2 (tle h2)|].
exact: (le_lt_trans (tle h1) (lt_le_trans ss (tle h2))).
Qed.
Definition Ln d (x : R) : R := \prod_(0 <= e < d) Ld d e x.
Fixpoint Q d (x : R) : R := if d is e.+1 then Ln e.+1 x * Q e x else 1.
Fixpoint deg d : nat := if d is e.+1 then (e.+1 + deg e)%N else 0.
Lemma degE d : deg d = (d * d.+1)./2.
Proof.
elim: d => // d IH; rewrite [deg _]/= IH -[d.+2]addn2 mulnDr muln2 [(d.+1 * d)%N]mulnC.
by rewrite halfD odd_double andbF doubleK add0n addnC.
Qed.
Lemma Q_positive d : positive a b (deg d) (Q d).
Proof.
elim: d => [|d IH] /=; first by exists (fun _ => 1) => [x|l _]; rewrite ?ltr01 // big_nat1 /mono subnn !expr0 !mulr1.
suff H c : (c <= d.+1)%N -> positive a b (c + deg d) (fun x => (\prod_(0 <= e < c) Ld d.+1 e x) * Q d x) by apply: H.
elim: c => [|c IHc] hc.
  by have [c h c0] := IH; exists c => // x; rewrite big_geq // mul1r.
have p0 : 0 < Ld d.+1 c b / (b - a) by rewrite divr_gt0 ?subr_gt0 // Ld_gt0 // lexx ltW.
have q0 : 0 < Ld d.+1 c a / (b - a) by rewrite divr_gt0 ?subr_gt0 // Ld_gt0 // lexx ltW.
have [c' h c0] := positive_lin p0 q0 (IHc (ltnW hc)); exists c' => // x.
by rewrite -h -(linear_ends (Ld_lin d.+1 c)) big_nat_recr //= mulrAC mulrC mulrA.
Qed.
Lemma Q_gt0 d x : a <= x <= b -> 0 < Q d x.
Proof.
move=> hx; elim: d => [|d IH] /=; first exact: ltr01.
by rewrite mulr_gt0 // /Ln big_nat_cond; apply: prodr_gt0 => e /andP[/andP[_ he] _]; apply: Ld_gt0.
Qed.
(* a weight, or its complement, times the denominators of its degree: one factor is exchanged *)
Lemma exchange d e (f : R -> R) x : (e < d)%N -> Ld d e x != 0 ->
  f x / Ld d e x * Ln d x = \prod_(0 <= c < d) (if c == e then f x else Ld d c x).
Proof.
move=> ed n; rewrite /Ln !big_mkord (bigD1 (Ordinal ed)) //= [in RHS](bigD1 (Ordinal ed)) //= eqxx mulrA divfK //; congr (_ * _).
by apply: eq_bigr => c hc; rewrite ifN //; apply: contra hc => /eqP h; apply/eqP/val_inj.
Qed.
Lemma exchange_bezier d e (f g : R -> R) D : (e < d)%N -> linear f -> bezier D g ->
  bezier (d + D) (fun x => (\prod_(0 <= c < d) (if c == e then f x else Ld d c x)) * g x).
Proof.
move=> ed hf hg; apply: (@bezier_prod R a b D d (fun c x => if c == e then f x else Ld d c x)) => // c hc.
case: (c == e) => //; exact: (linear_of (Ld_lin d c)).
Qed.
(* each piece times the denominators, as a polynomial that is equal to it on the span *)
Theorem N_bezier d i : exists2 f, bezier (deg d) f & forall x, a <= x <= b -> N (fun e j => mw r t e j x) s d i * Q d x = f x.
Proof.
elim: d i => [|d IH] i.
  exists (fun _ => (i == s)%:R) => [|x _]; last by rewrite /= mulr1.
  by exists (fun _ => (i == s)%:R) => x; rewrite big_nat1 /mono subnn !expr0 !mulr1.
have A : exists2 f, bezier (deg d.+1) f & forall x, a <= x <= b -> mw r t d.+1 i x * N (fun e j => mw r t e j x) s d i * Q d.+1 x = f x.
  case: (boolP (i <= s <= i + d)%N) => hi; last first.
    by exists (fun _ => 0); [exact: bezier_0|move=> x _; rewrite N_supp // mulr0 mul0r].
  have [f bf ef] := IH i; have ed : (s - i < d.+1)%N by move: hi; clear; lia.
  have es : (s - (s - i) = i)%N by move: hi; clear; lia.
  have hl : linear (fun x => r * (x - t i)) by apply: (@linear_of _ r (- (r * t i))) => x; ring.
  exists (fun x => (\prod_(0 <= c < d.+1) (if c == (s - i)%N then r * (x - t i) else Ld d.+1 c x)) * f x); first exact: exchange_bezier.
  move=> x hx; have n := Ld_gt0 ed hx.
  rewrite -(@exchange d.+1 (s - i) (fun x => r * (x - t i)) x ed) ?gt_eqF // -ef //=.
  have -> : mw r t d.+1 i x = r * (x - t i) / Ld d.+1 (s - i) x by rewrite /mw /mob /Ld es.
  by move: (_ / _) (N _ s d i) (Ln d.+1 x) (Q d x) => u v w z; ring.
have B : exists2 f, bezier (deg d.+1) f & forall x, a <= x <= b -> (1 - mw r t d.+1 i.+1 x) * N (fun e j => mw r t e j x) s d i.+1 * Q d.+1 x = f x.
  case: (boolP (i.+1 <= s <= i.+1 + d)%N) => hi; last first.
    by exists (fun _ => 0); [exact: bezier_0|move=> x _; rewrite N_supp // mulr0 mul0r].
  have [f bf ef] := IH i.+1; have ed : (s - i.+1 < d.+1)%N by move: hi; clear; lia.
  have es : (s - (s - i.+1) = i.+1)%N by move: hi; clear; lia.
  have hl : linear (fun x => t (i.+1 + d.+1)%N - x) by apply: (@linear_of _ (-1) (t (i.+1 + d.+1)%N)) => x; ring.
  exists (fun x => (\prod_(0 <= c < d.+1) (if c == (s - i.+1)%N then t (i.+1 + d.+1)%N - x else Ld d.+1 c x)) * f x); first exact: exchange_bezier.
  move=> x hx; have n := Ld_gt0 ed hx.
  rewrite -(@exchange d.+1 (s - i.+1) (fun x => t (i.+1 + d.+1)%N - x) x ed) ?gt_eqF // -ef //=.
  have n' : Ld d.+1 (s - i.+1) x != 0 by rewrite gt_eqF.
  have -> : 1 - mw r t d.+1 i.+1 x = (t (i.+1 + d.+1)%N - x) / Ld d.+1 (s - i.+1) x.
    move: n'; rewrite /mw /mob /Ld es; move: (t i.+1) (t (i.+1 + d.+1)%N) => u v n'; by field.
  by move: (_ / _) (N _ s d i.+1) (Ln d.+1 x) (Q d x) => u v w z; ring.
have [f bf ef] := A; have [g bg eg] := B; exists (fun x => f x + g x); first exact: bezier_add.
by move=> x hx; rewrite NS mulrDl ef // eg.
Qed.
End Span.

Section Statement.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
(* Bernstein's polynomials of degree D on [a,b], times (b-a)^D *)
Definition B (a b : R) D l x : R := 'C(D, l)%:R * ((x - a) ^+ l * (b - x) ^+ (D - l)).
(* X.nurbs, the bound: on every span all functions are rational Bézier curves of degree k(k+1)/2 with the same positive weights W_l *)
Theorem X_nurbs_printed j : (1 <= k)%N -> (j < m)%N -> t j < t j.+1 -> exists W : nat -> R, exists p : nat -> nat -> R,
  let D := (k * k.+1)./2 in [/\ forall l, (l <= D)%N -> 0 < W l, forall x, t j <= x <= t j.+1 -> 0 < \sum_(0 <= l < D.+1) W l * B (t j) (t j.+1) D l x &
    forall i x, (i <= n)%N -> t j < x < t j.+1 -> value r t m k i x =
      (\sum_(0 <= l < D.+1) W l * p i l * B (t j) (t j.+1) D l x) / (\sum_(0 <= l < D.+1) W l * B (t j) (t j.+1) D l x)].
Proof.
move=> _ jm h; have [c hc c0] := Q_positive r0 t_mono h k; rewrite degE in hc c0; set D := (k * k.+1)./2 in hc c0.
have bin l : (l <= D)%N -> ('C(D, l)%:R : R) != 0 by move=> hl; rewrite pnatr_eq0 -lt0n bin_gt0.
have [P hP] : exists P : nat -> nat -> R, forall i, (i < n.+1)%N -> forall x, t j <= x <= t j.+1 ->
    N (fun e l => mw r t e l x) j k i * Q r t j k x = \sum_(0 <= l < D.+1) P i l * mono (t j) (t j.+1) D l x.
  have ex i : exists P : nat -> R, forall x, t j <= x <= t j.+1 ->
      N (fun e l => mw r t e l x) j k i * Q r t j k x = \sum_(0 <= l < D.+1) P l * mono (t j) (t j.+1) D l x.
    by have [f [P hP] ef] := N_bezier r0 t_mono h k i; rewrite degE in hP; exists P => x hx; rewrite ef.
  elim: n.+1 => [|c' [P hP]]; first by exists (fun _ _ => 0).
  have [P' hP'] := ex c'; exists (fun i => if i == c' then P' else P i) => i; rewrite ltnS leq_eqVlt => /orP[/eqP ->|lt].
    by rewrite eqxx.
  by rewrite (ltn_eqF lt); exact: hP.
have EQ x : Q r t j k x = \sum_(0 <= l < D.+1) (c l / 'C(D, l)%:R) * B (t j) (t j.+1) D l x.
  rewrite hc; apply: eq_big_nat => l /andP[_ hl]; rewrite /B mulrA divfK ?bin // -ltnS //.
exists (fun l => c l / 'C(D, l)%:R), (fun i l => P i l / c l); split.
- by move=> l hl; rewrite divr_gt0 ?c0 // ltr0n bin_gt0.
- by move=> x hx; rewrite -EQ; exact: Q_gt0.
move=> i x im hx; have /andP[x1 x2] := hx; have hx' : t j <= x <= t j.+1 by rewrite !ltW.
rewrite value_in; last by apply: (lt_le_trans x2); exact: t_le.
rewrite (G_P r t_mono _ _ (s := j)) ?(ltW x1) // -EQ.
have -> : \sum_(0 <= l < D.+1) c l / 'C(D, l)%:R * (P i l / c l) * B (t j) (t j.+1) D l x = Pieces.P r t j k i x * Q r t j k x.
  rewrite [RHS](hP i im x hx'); apply: eq_big_nat => l /andP[_ hl]; rewrite ltnS in hl.
  have n1 := bin l hl; have n2 : c l != 0 by rewrite gt_eqF // c0.
  rewrite /B /mono; move: (_ ^+ l * _) => u; by field; rewrite n1 n2.
by rewrite mulfK // gt_eqF // Q_gt0.
Qed.
End Statement.
