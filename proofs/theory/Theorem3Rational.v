(* Theorem 3 for rational knots, ratio and points: what exact rational arithmetic computes. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring realalg.
From Bsplines Require Import Definitions Race RationalDerivative Theorem3Table Theorem3.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* The same for rational knots, ratio and points (what exact arithmetic computes): by the embedding into the real algebraic numbers. *)
Section Rat.
Variable r : rat.
Hypothesis r0 : 0 < r.
Variable t : nat -> rat.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable RA : rcfType.
Notation f := (@ratr RA).
Local Notation G := Definitions.G.
Local Notation N := (G (wt r t) t).

Lemma N_ratr k i x : G (wt (f r) (fun j => f (t j))) (fun j => f (t j)) k i (f x) = f (N k i x).
Proof.
elim: k i => [|k IH] i.
  by rewrite /= ler_rat ltr_rat; case: ifP => _; [rewrite (rmorph1 (ratr_rmorphism RA)) | rewrite (rmorph0 (ratr_rmorphism RA))].
have w j n : wt (f r) (fun j => f (t j)) n j (f x) = f (wt r t n j x).
  rewrite /wt /phi /mob ler_rat ltr_rat; case: ifP => _; last by rewrite rmorph0.
  by rewrite fmorph_div /= !(rmorphD, rmorphM, rmorphN).
by rewrite !GS !IH !w !(rmorphD, rmorphM, rmorphN, rmorph1).
Qed.

(* Theorem 3 for rational knots, ratio and points, by the embedding into a real closed field *)
Theorem rat_unimodal k i s x y z : (0 < k)%N -> (i <= s <= i + k)%N ->
  t s < x -> x < y -> y < z -> z < t s.+1 -> Num.min (N k i x) (N k i z) < N k i y.
Proof.
move=> k0 is_ sx xy yz zs.
have h := @paper_unimodal _ (f r) _ (fun j => f (t j)) _ k i s (f x) (f y) (f z) k0 is_.
have : Num.min (f (N k i x)) (f (N k i z)) < f (N k i y).
  rewrite -!N_ratr; apply: h; rewrite ?ltr_rat // ?ltr0q //.
  by move=> j; rewrite ler_rat.
by rewrite !lt_minl !ltr_rat.
Qed.

(* the same for the triples of Theorem3Table.v *)
Definition tmap (p : triple [realFieldType of rat]) : triple RA := (f p.1.1, f p.1.2, f p.2).
Lemma tmap_add p q : tmap (tadd p q) = tadd (tmap p) (tmap q).
Proof. by rewrite /tmap /tadd /= !rmorphD. Qed.
Lemma tmap_mul p q : tmap (tmul p q) = tmul (tmap p) (tmap q).
Proof. by rewrite /tmap /tmul /=; congr (_, _, _); rewrite ?rmorphD ?rmorphM ?rmorph_nat. Qed.
Variables tl tr : nat -> rat.
Notation ftl := (fun n => f (tl n)). Notation ftr := (fun n => f (tr n)).
Lemma tmap_w x n m : tmap (tw r tl tr x n m) = tw (f r) ftl ftr (f x) n m.
Proof.
rewrite /tmap /tw /Race.den /a /b /=; congr (_, _, _);
by rewrite ?rmorphN fmorph_div /= ?rmorphX !(rmorphD, rmorphM, rmorphN, rmorph1).
Qed.
Lemma tmap_v x n m : tmap (tv r tl tr x n m) = tv (f r) ftl ftr (f x) n m.
Proof.
rewrite /tmap /tv /Race.den /a /b /=; congr (_, _, _);
by rewrite ?rmorphN fmorph_div /= ?rmorphX !(rmorphD, rmorphM, rmorphN, rmorph1).
Qed.
Lemma G3_ratr x n m : G3 (f r) ftl ftr (f x) n m = tmap (G3 r tl tr x n m).
Proof.
have one : tmap (one3 [realFieldType of rat]) = one3 RA.
  by rewrite /tmap /one3 /= (rmorph1 (ratr_rmorphism RA)) (rmorph0 (ratr_rmorphism RA)).
elim: n m => [|n IHn] m.
  elim: m => [|m IHm]; first exact: esym one.
  have -> : G3 r tl tr x 0 m.+1 = tmul (tw r tl tr x 0 m) (G3 r tl tr x 0 m) by [].
  by rewrite tmap_mul -IHm tmap_w.
elim: m => [|m IHm].
  have -> : G3 r tl tr x n.+1 0 = tmul (tv r tl tr x n 0) (G3 r tl tr x n 0) by [].
  by rewrite tmap_mul -IHn tmap_v.
by rewrite !G3SS tmap_add !tmap_mul -IHm -IHn !tmap_w !tmap_v.
Qed.
Variables u v : rat.
Hypothesis tlu : forall n, tl n <= u.
Hypothesis trv : forall m, v <= tr m.
Hypothesis tl_mono : forall n, tl n.+1 <= tl n.
Hypothesis tr_mono : forall m, tr m <= tr m.+1.
(* the same for the derivative in the table *)
Theorem rat_theorem3 n m x y : (0 < n + m)%N -> u < x -> x < y -> y < v ->
  (G3 r tl tr x n m).1.2 <= 0 -> (G3 r tl tr y n m).1.2 < 0.
Proof.
move=> nm ux xy yv h.
have h' := @theorem3 RA (f r) _ (f u) (f v) ftl ftr _ _ _ _ n m (f x) (f y) nm.
move: h'; rewrite !G3_ratr /tmap /= lerq0 ltrq0 !ltr_rat ltr0q; apply=> // k; by rewrite ler_rat.
Qed.
End Rat.

(* X.maxima.spans: the same for rational knots, ratio and points *)
Theorem rational_unimodal (r : rat) (t : nat -> rat) k i s x y z : 0 < r -> (forall j, t j <= t j.+1) ->
  (0 < k)%N -> (i <= s <= i + k)%N -> t s < x -> x < y -> y < z -> z < t s.+1 ->
  let G := Definitions.G (wt r t) t in Num.min (G k i x) (G k i z) < G k i y.
Proof. by move=> r0 tm; apply: (rat_unimodal r0 tm [rcfType of realalg]). Qed.

(* Theorem 3 for rational numbers: once the derivative is <= 0 it is < 0 on the rest of the span *)
Theorem rational_theorem3 (r u v : rat) (tl tr : nat -> rat) n m x y : 0 < r ->
  (forall j, tl j <= u) -> (forall j, v <= tr j) -> (forall j, tl j.+1 <= tl j) -> (forall j, tr j <= tr j.+1) ->
  (0 < n + m)%N -> u < x -> x < y -> y < v ->
  (G3 r tl tr x n m).1.2 <= 0 -> (G3 r tl tr y n m).1.2 < 0.
Proof. move=> r0 h1 h2 h3 h4; exact: (@rat_theorem3 r r0 [rcfType of realalg] tl tr u v h1 h2 h3 h4). Qed.
