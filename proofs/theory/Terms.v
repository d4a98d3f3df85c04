(* What the printed stanzas of Stanzas.v are made of, besides the definitions of the other files: knots with their adjectives, and
   limits and derivatives from one side, at every real x. Outside of the knots a function is 0, and so are its limits there. *)
From mathcomp Require Import all_ssreflect all_algebra.
From Bsplines Require Import Definitions Pieces Derivatives Values.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Terms.
Variable R : realFieldType.
Implicit Types (r x : R) (t : nat -> R) (m n k i : nat).

(* U: of an infinite sequence the knots t_0, ..., t_m count; continue t_0, ..., t_m with t_m *)
Definition knots t m := (forall i, t i <= t i.+1) /\ t 0%N < t m.
Definition Usimple t m := forall i, (i < m)%N -> t i < t i.+1.
Definition Ubernstein t n k := Uopen t n k /\ n = k.

(* a quotient of polynomials on (u, v), without a pole there and at the ends *)
Definition rational_on (u v : R) (f : R -> R) := exists P Q : {poly R},
  (forall x, u <= x <= v -> Q.[x] != 0) /\ forall x, u < x < v -> f x = P.[x] / Q.[x].

(* G_i^k(x-), G_i^k(x+), and the derivatives from both sides *)
Definition Gleft r t m k i x := if t 0%N < x <= t m then limit_left r t m k i x else 0.
Definition Gright r t m k i x := if t 0%N <= x < t m then P r t (right_span t m x) k i x else 0.
Definition DGleft r t m k i x := if t 0%N < x <= t m then Dleft r t m k i x else 0.
Definition DGright r t m k i x := if t 0%N <= x < t m then Dright r t m k i x else 0.

Variable (r : R) (t : nat -> R) (m : nat).
Hypothesis (r_gt0 : 0 < r) (U : knots t m).
Lemma Gleft_in k i x : t 0%N < x <= t m -> Gleft r t m k i x = limit_left r t m k i x.
Proof. by rewrite /Gleft => ->. Qed.
Lemma DGleft_in k i x : t 0%N < x <= t m -> DGleft r t m k i x = Dleft r t m k i x.
Proof. by rewrite /DGleft => ->. Qed.
Lemma DGright_in k i x : t 0%N <= x < t m -> DGright r t m k i x = Dright r t m k i x.
Proof. by rewrite /DGright => ->. Qed.
Lemma ends : [/\ t 0%N < t m <= t m, t 0%N <= t 0%N < t m & t 0%N <= t m].
Proof. by have [_ h] := U; rewrite h !lexx ltW. Qed.
Lemma Gleft_tm k i : Gleft r t m k i (t m) = limit_left r t m k i (t m).
Proof. by have [h _ _] := ends; apply: Gleft_in. Qed.
Lemma DGleft_tm k i : DGleft r t m k i (t m) = Dleft r t m k i (t m).
Proof. by have [h _ _] := ends; apply: DGleft_in. Qed.
Lemma DGright_t0 k i : DGright r t m k i (t 0%N) = Dright r t m k i (t 0%N).
Proof. by have [_ h _] := ends; apply: DGright_in. Qed.
(* the limit from the right is the value *)
Lemma Gright_in k i x : t 0%N <= x < t m -> Gright r t m k i x = value r t m k i x.
Proof.
move=> h; rewrite /Gright h; have [_ s] := @right_spanP _ t m x h.
by case/andP: (h) => _ xm; rewrite value_in // (G_P r (proj1 U) k i s).
Qed.
End Terms.
