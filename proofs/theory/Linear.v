(* X.linear: for r <> 1 no combination of the functions is a power of x on any span, for every degree. For r <> 1 every weight is P/Q with
   the degree of P at most that of Q, and so are all functions; a power of x is not. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives RationalDerivative Values.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Regular.
Variable R : realFieldType.
Variables u v : R.
Hypothesis uv : u < v.
(* a quotient that stays bounded at infinity, without a pole in (u,v) *)
Definition regular (f : R -> R) := exists P Q : {poly R}, (size P <= size Q)%N /\
  forall x, u < x < v -> Q.[x] != 0 /\ f x = P.[x] / Q.[x].
Let mid : u < (u + v) / 2%:R < v. Proof. by rewrite !midf_lt. Qed.
Lemma reg_Q0 (Q : {poly R}) : (forall x, u < x < v -> Q.[x] != 0) -> Q != 0.
Proof. by move=> h; apply/eqP => e; have := h _ mid; rewrite e horner0 eqxx. Qed.
Lemma regular_ext f g : regular f -> (forall x, u < x < v -> g x = f x) -> regular g.
Proof. by case=> P [Q [s h]] e; exists P, Q; split => // x hx; have [a b] := h x hx; rewrite e. Qed.
Lemma regular_const c : regular (fun _ => c).
Proof.
exists c%:P, 1; split; first by rewrite size_poly1 size_polyC; case: (c != 0).
by move=> x _; rewrite !hornerE divr1 oner_neq0.
Qed.
Lemma size_mul_le (P P' Q Q' : {poly R}) : Q != 0 -> Q' != 0 -> (size P <= size Q)%N -> (size P' <= size Q')%N -> (size (P * P')%R <= size (Q * Q')%R)%N.
Proof.
move=> q q' h h'; rewrite (size_mul q q'); case: (eqVneq P 0) => [->|p]; first by rewrite mul0r size_poly0.
case: (eqVneq P' 0) => [->|p']; first by rewrite mulr0 size_poly0.
by rewrite size_mul // -!subn1 leq_sub2r // leq_add.
Qed.
Lemma regular_mul f g : regular f -> regular g -> regular (fun x => f x * g x).
Proof.
case=> P [Q [s h]] [P' [Q' [s' h']]]; exists (P * P'), (Q * Q'); split.
  by apply: size_mul_le => //; apply: reg_Q0 => x hx; [have [] := h x hx|have [] := h' x hx].
move=> x hx; have [a b] := h x hx; have [a' b'] := h' x hx.
by rewrite !hornerM mulf_neq0 // b b' invfM mulrACA.
Qed.
Lemma regular_add f g : regular f -> regular g -> regular (fun x => f x + g x).
Proof.
case=> P [Q [s h]] [P' [Q' [s' h']]]; exists (P * Q' + P' * Q), (Q * Q'); split.
  have q : Q != 0 by apply: reg_Q0 => x hx; have [] := h x hx.
  have q' : Q' != 0 by apply: reg_Q0 => x hx; have [] := h' x hx.
  apply: leq_trans (size_add _ _) _; rewrite geq_max; apply/andP; split.
    exact: size_mul_le.
  by rewrite mulrC; apply: size_mul_le.
move=> x hx; have [a b] := h x hx; have [a' b'] := h' x hx.
rewrite hornerD !hornerM mulf_neq0 // b b'; split => //.
by move: a a'; move: P.[x] Q.[x] P'.[x] Q'.[x] => p q p' q' a a'; field; rewrite a a'.
Qed.
Lemma regular_sum (I : Type) (s : seq I) (f : I -> R -> R) : (forall i, regular (f i)) -> regular (fun x => \sum_(i <- s) f i x).
Proof.
move=> h; elim: s => [|i s IH].
  by apply: (regular_ext (regular_const 0)) => x _; rewrite big_nil.
by apply: (regular_ext (regular_add (h i) IH)) => x _; rewrite big_cons.
Qed.
(* no polynomial that is not constant is *)
Theorem poly_not_regular (p : {poly R}) : (1 < size p)%N -> ~ regular (fun x => p.[x]).
Proof.
move=> p1 [P [Q [s h]]]; have Q0 : Q != 0 by apply: reg_Q0 => x hx; have [] := h x hx.
have p0 : p != 0 by rewrite -size_poly_gt0 ltnW.
have E : P - p * Q = 0.
  by apply: (poly0 uv) => x hx; have [a b] := h x hx; rewrite hornerD hornerN hornerM b divfK // subrr.
have : (size Q < size P)%N.
  have -> : P = p * Q by apply/eqP; rewrite -subr_eq0 E.
  by rewrite size_mul // -(ltn_predK p1) addSn /= -[X in (X < _)%N]add0n ltn_add2r -ltnS (ltn_predK p1).
by rewrite ltnNge s.
Qed.
(* so no power of x is *)
Theorem power_not_regular q : (0 < q)%N -> ~ regular (fun x => x ^+ q).
Proof.
move=> q0 h; apply: (@poly_not_regular 'X^q); first by rewrite size_polyXn ltnS.
by apply: (regular_ext h) => x _; rewrite hornerXn.
Qed.
End Regular.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Hypothesis r1 : r != 1.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variable s : nat.
Hypothesis ss : t s < t s.+1.
Local Notation regular := (regular (t s) (t s.+1)).
Lemma mob_regular a b : a <= t s -> t s.+1 <= b -> regular (fun x => mob r x a b).
Proof.
move=> ha hb; exists (r%:P * ('X - a%:P)), (r%:P * ('X - a%:P) + (b%:P - 'X)); split; last first.
  move=> x /andP[x1 x2]; rewrite !hE.
  by rewrite mob_den_neq0 ?(le_trans ha (ltW x1)) ?(le_trans (ltW x2)) // (lt_le_trans (le_lt_trans ha x1)) // (le_trans (ltW x2)).
have -> : r%:P * ('X - a%:P) + (b%:P - 'X) = (r - 1)%:P * 'X + (b - r * a)%:P.
  have -> : (r - 1)%:P = r%:P - 1 :> {poly R} by rewrite polyCB polyC1.
  have -> : (b - r * a)%:P = b%:P - r%:P * a%:P :> {poly R} by rewrite polyCB polyCM.
  by move: (r%:P) (a%:P) (b%:P) ('X : {poly R}) => x1 x2 x3 x4; ring.
have -> : size ((r - 1)%:P * 'X + (b - r * a)%:P) = 2%N.
  by rewrite size_MXaddC polyC_eq0 subr_eq0 (negbTE r1) /= size_polyC subr_eq0 r1.
by rewrite mul_polyC size_scale ?gt_eqF // size_XsubC.
Qed.
Lemma N_regular d i : regular (fun x => N (fun e j => mw r t e j x) s d i).
Proof.
elim: d i => [|d IH] i; first exact: regular_const.
have W e j : (j <= s < j + e)%N -> regular (mw r t e j) by move=> /andP[a b]; apply: mob_regular; apply: tle.
have W1 e j : (j <= s < j + e)%N -> regular (fun x => 1 - mw r t e j x).
  move=> h; apply: (regular_ext (regular_add ss (regular_const _ _ 1) (regular_mul ss (regular_const _ _ (-1)) (W e j h)))) => x _; ring.
have z : regular (fun _ => 0) by exact: regular_const.
have A : regular (fun x => if (i <= s <= i + d)%N then mw r t d.+1 i x * N (fun e j => mw r t e j x) s d i else 0).
  case: (boolP (i <= s <= i + d)%N) => h; last exact: z.
  by apply: (regular_mul ss (W d.+1 i _) (IH i)); move: h; clear; lia.
have B : regular (fun x => if (i.+1 <= s <= i.+1 + d)%N then (1 - mw r t d.+1 i.+1 x) * N (fun e j => mw r t e j x) s d i.+1 else 0).
  case: (boolP (i.+1 <= s <= i.+1 + d)%N) => h; last exact: z.
  by apply: (regular_mul ss (W1 d.+1 i.+1 _) (IH i.+1)); move: h; clear; lia.
apply: (regular_ext (regular_add ss A B)) => x _; rewrite NS; congr (_ + _).
  by case: ifP => h //; rewrite N_supp ?h ?mulr0.
by case: ifP => h //; rewrite N_supp ?h ?mulr0.
Qed.
(* no polynomial but the constants is a combination of the functions on any span *)
Theorem no_polynomial n k (p : {poly R}) (c : nat -> R) : (s < n + k.+1)%N -> (1 < size p)%N ->
  ~ (forall x, t s <= x <= t s.+1 -> p.[x] = \sum_(0 <= i < n.+1) c i * value r t (n + k.+1) k i x).
Proof.
move=> sm p1 H; apply: (@poly_not_regular R (t s) (t s.+1) ss p p1).
have reg : regular (fun x => \sum_(0 <= i < n.+1) c i * N (fun e j => mw r t e j x) s k i).
  apply: (regular_sum ss) => i; apply: (regular_mul ss); [exact: regular_const|exact: N_regular].
apply: (regular_ext reg) => x /andP[x1 x2]; rewrite H ?(ltW x1) ?(ltW x2) //.
apply: eq_bigr => i _; rewrite value_in; last by apply: (lt_le_trans x2); exact: tle.
by rewrite (G_P r t_mono k i (s := s)) // (ltW x1).
Qed.
(* X.linear as amended *)
Theorem X_linear_amended n k q (c : nat -> R) : (s < n + k.+1)%N -> (1 <= q)%N ->
  ~ (forall x, t s <= x <= t s.+1 -> x ^+ q = \sum_(0 <= i < n.+1) c i * value r t (n + k.+1) k i x).
Proof.
move=> sm q1 H; apply: (@no_polynomial n k 'X^q c sm); first by rewrite size_polyXn ltnS.
by move=> x hx; rewrite hornerXn; apply: H.
Qed.
End Paper.

(* X.linear as printed: false for every degree, on every knot vector with t_k < t_(n+1) *)
Theorem X_linear_printed_false (R : realFieldType) (r : R) t n k (c : nat -> R) : 0 < r -> r != 1 -> (forall i, t i <= t i.+1) ->
  t k < t n.+1 -> ~ (forall x, t k <= x <= t n.+1 -> x = \sum_(0 <= i < n.+1) c i * value r t (n + k.+1) k i x).
Proof.
move=> r0 r1 mono h H.
have [s [/andP[ks sn] /andP[s1 s2]]] := span_exists mono (introT andP (conj (lexx (t k)) h)).
apply: (@X_linear_amended R r r0 r1 t mono s (le_lt_trans s1 s2) n k 1 c) => //; first by move: sn; clear; lia.
move=> x /andP[x1 x2]; rewrite expr1; apply: H; apply/andP; split; first exact: le_trans (t_le mono ks) x1.
by apply: le_trans x2 _; apply: (t_le mono).
Qed.
