(* The sentences of the claims, printed from their stanzas by `knotproof report --record`, and not by hand; a test holds the two
   together. `X_defined` says that everything exists that `X` names, where the hypotheses do not say so themselves: indices are
   in their ranges, integers below 0 do not occur, nothing is divided by 0. Bridge.v has the proofs. *)
From mathcomp Require Import all_ssreflect all_algebra.
From Bsplines Require Import Definitions Pieces Derivatives Values RationalDerivative Terms.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Stanzas.
Variable R : realFieldType.

(* abstract.classical printed: no term of the theory says the sentence P4.1.1 *)

(* abstract.classical amended: no term of the theory says the sentence P4.1.1 *)

(* abstract.bezier printed: k >= 1; U bernstein; s > 0; x in (t[0], t[m]) : G[0](x; r = s) < G[0](x) <=> r < s *)
Definition abstract_bezier_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall s : R,
  0 < s ->
  forall x : R,
  t 0%N < x < t m ->
  (value s t m k 0%N x < value r t m k 0%N x <-> r < s).

(* abstract.bezier.points printed: k >= 1; U bernstein | alpha != infinity : some(i in 0..k: some(x in (t[0], t[m]): G[i](x) != binomial(k, i)*f(x, t[0], t[m])^i*(1 - f(x, t[0], t[m]))^(k-i))) *)
Definition abstract_bezier_points_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  r != 1 ->
  (exists i : nat, (i <= k)%N /\ (exists x : R, t 0%N < x < t m /\ value r t m k i x != ('C(k, i))%:R * (mob r x (t 0%N) (t m)) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i)%N)).
Definition abstract_bezier_points_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  r != 1 ->
  (forall i : nat, (i <= k)%N -> (forall x : R, t 0%N < x < t m -> (i <= n)%N /\ r * (x - (t 0%N)) + ((t m) - x) != 0)).

(* abstract.bezier.points amended: k; U bernstein; d points; x in [t[0], t[m]] : C(x) = sum(i in 0..k: d[i]*binomial(k, i)*f(x, t[0], t[m])^i*(1 - f(x, t[0], t[m]))^(k-i)) *)
Definition abstract_bezier_points_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall d : nat -> R,
  forall x : R,
  t 0%N <= x <= t m ->
  \sum_(0 <= i < n.+1) d i * value r t m k i x = \sum_(0 <= i < k.+1) d i * ('C(k, i))%:R * (mob r x (t 0%N) (t m)) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i)%N.
Definition abstract_bezier_points_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall d : nat -> R,
  forall x : R,
  t 0%N <= x <= t m ->
  (forall i : nat, (i <= k)%N -> (i <= n)%N /\ r * (x - (t 0%N)) + ((t m) - x) != 0).

(* abstract.regularity printed: no term of the theory says a derivative that is not one of order 1 from one side *)

(* phi.range printed: a; b; x : 0 <= phi(x, a, b) < 1 *)
Definition phi_range_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  0 <= phi r x a b < 1.

(* phi.shape printed: no term of the theory says the limit of a weight or of a curve *)

(* L2.1 printed: no term of the theory says a derivative that is not one of order 1 from one side *)

(* R2.2.1 printed: a; b; x in [a, b] | alpha != infinity; a < b : x + (alpha - 1)*b - alpha*a != 0 *)
Definition R2_2_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  a <= x <= b ->
  r != 1 ->
  a < b ->
  x + (r / (r - 1) - 1) * b - r / (r - 1) * a != 0.
Definition R2_2_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  a <= x <= b ->
  r != 1 ->
  a < b ->
  r - 1 != 0.

(* R2.2.2a printed: no term of the theory says the limit of a weight or of a curve *)

(* R2.2.2b printed: a; b; x in [a, b] | a < b : abs(f(x, a, b) - (x - a)/(b - a)) <= abs(r - 1) *)
Definition R2_2_2b_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  a <= x <= b ->
  a < b ->
  `|mob r x a b - (x - a) / (b - a)| <= `|r - 1|.
Definition R2_2_2b_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  a <= x <= b ->
  a < b ->
  r * (x - a) + (b - x) != 0 /\ (b - a) != 0 :> R.

(* R2.2.2c printed: a; b; x in [a, b] | a < b : f(a + b - x, a, b) = 1 - f(x, a, b; alpha = 1 - alpha); f(x, a, b) = 1 - f(a + b - x, a, b; alpha = 1 - alpha) *)
Definition R2_2_2c_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  a <= x <= b ->
  a < b ->
  mob r (a + b - x) a b = 1 - mob r^-1 x a b /\
  mob r x a b = 1 - mob r^-1 (a + b - x) a b.
Definition R2_2_2c_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  a <= x <= b ->
  a < b ->
  r * ((a + b - x) - a) + (b - (a + b - x)) != 0 /\ r^-1 * (x - a) + (b - x) != 0 /\ r * (x - a) + (b - x) != 0 /\ r^-1 * ((a + b - x) - a) + (b - (a + b - x)) != 0.

(* P2.1.1 printed: a; b; x : 0 <= phi(x, a, b) <= 1 *)
Definition P2_1_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall x : R,
  0 <= phi r x a b <= 1.

(* P2.1.2 printed: a; b; s > 0; c; x : phi(s*x + c, s*a + c, s*b + c) = phi(x, a, b) *)
Definition P2_1_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall s : R,
  0 < s ->
  forall c : R,
  forall x : R,
  phi r (s * x + c) (s * a + c) (s * b + c) = phi r x a b.

(* P2.1.3 printed: a; b; s < 0; c; x : phi(s*x + c, s*b + c, s*a + c) = 1 - phi(x, a, b; alpha = 1 - alpha) *)
Definition P2_1_3_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall s : R,
  s < 0 ->
  forall c : R,
  forall x : R,
  phi r (s * x + c) (s * b + c) (s * a + c) = 1 - phi r^-1 x a b.

(* P2.1.3 amended: a; b; s < 0; c; x in (a, b) : phi(s*x + c, s*b + c, s*a + c) = 1 - phi(x, a, b; alpha = 1 - alpha) *)
Definition P2_1_3_amended : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall s : R,
  s < 0 ->
  forall c : R,
  forall x : R,
  a < x < b ->
  phi r (s * x + c) (s * b + c) (s * a + c) = 1 - phi r^-1 x a b.

(* P2.1.3 fails: a; b; s < 0; c; x | not a < x < b : phi(s*x + c, s*b + c, s*a + c) + phi(x, a, b; alpha = 1 - alpha) = 0 *)
Definition P2_1_3_fails : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall s : R,
  s < 0 ->
  forall c : R,
  forall x : R,
  ~ (a < x < b) ->
  phi r (s * x + c) (s * b + c) (s * a + c) + phi r^-1 x a b = 0.

(* C2.4 printed: a; b; t1; t2; x in [a, b] | a <= t1 < t2 <= b : phi(a + b - x, t1, t2) = 1 - phi(x, a + b - t2, a + b - t1; alpha = 1 - alpha) *)
Definition C2_4_printed : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall t1 : R,
  forall t2 : R,
  forall x : R,
  a <= x <= b ->
  (a <= t1 /\ t1 < t2 /\ t2 <= b) ->
  phi r (a + b - x) t1 t2 = 1 - phi r^-1 x (a + b - t2) (a + b - t1).

(* C2.4 amended: a; b; t1; t2; x in (a + b - t2, a + b - t1) | a <= t1 < t2 <= b : phi(a + b - x, t1, t2) = 1 - phi(x, a + b - t2, a + b - t1; alpha = 1 - alpha) *)
Definition C2_4_amended : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall t1 : R,
  forall t2 : R,
  forall x : R,
  a + b - t2 < x < a + b - t1 ->
  (a <= t1 /\ t1 < t2 /\ t2 <= b) ->
  phi r (a + b - x) t1 t2 = 1 - phi r^-1 x (a + b - t2) (a + b - t1).

(* C2.4 fails: a; b; t1; t2; x in [a, b] | a <= t1 < t2 <= b; not a + b - t2 < x < a + b - t1 : phi(a + b - x, t1, t2) + phi(x, a + b - t2, a + b - t1; alpha = 1 - alpha) = 0 *)
Definition C2_4_fails : Prop :=
  forall r : R,
  0 < r ->
  forall a : R,
  forall b : R,
  forall t1 : R,
  forall t2 : R,
  forall x : R,
  a <= x <= b ->
  (a <= t1 /\ t1 < t2 /\ t2 <= b) ->
  ~ (a + b - t2 < x < a + b - t1) ->
  phi r (a + b - x) t1 t2 + phi r^-1 x (a + b - t2) (a + b - t1) = 0.

(* Ill2.1 printed: no term of the theory says a derivative that is not one of order 1 from one side *)

(* Ill2.1.crucial printed: no term of the theory says a root *)

(* D3.1.interval printed: k >= 1; U; i in 0..m | t[k] < t[m-k] : t[k] <= t[i] <= t[m-k] *)
Definition D3_1_interval_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= m)%N ->
  t k < t n.+1 ->
  t k <= t i <= t n.+1.

(* D3.1.interval amended: k >= 1; U | t[k] < t[m-k] : all(i in 0..m: t[k] <= t[i] <= t[m-k]) <=> t[0] = t[k] and t[m-k] = t[m] *)
Definition D3_1_interval_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  t k < t n.+1 ->
  ((forall i : nat, (i <= m)%N -> t k <= t i <= t n.+1) <-> (t 0%N = t k /\ t n.+1 = t m)).

(* D3.2.stop printed: no term of the theory says the word stops *)

(* T3.5.1 printed: k; U; i in 0..n; x | not x in (t[i], t[i+k+1]) : G[i](x) = 0 *)
Definition T3_5_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  ~ (t i < x < t ((i + k).+1)%N) ->
  value r t m k i x = 0.
Definition T3_5_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  (i <= m)%N.

(* T3.5.1 amended: k; U; i in 0..n; x | not x in (t[i], t[i+k+1]); not x = t[i] = t[i+k] < t[i+k+1]; not t[i] < t[i+1] = t[m] = x : G[i](x) = 0 *)
Definition T3_5_1_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  ~ (t i < x < t ((i + k).+1)%N) ->
  ~ (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t ((i + k).+1)%N) ->
  ~ (t i < t i.+1 /\ t i.+1 = t m /\ t m = x) ->
  value r t m k i x = 0.
Definition T3_5_1_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  (i <= m)%N /\ (~ (t i < x < t ((i + k).+1)%N) ->
  (i <= n.+1)%N /\ (~ (x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t ((i + k).+1)%N) ->
  (i <= n + k)%N)).

(* T3.5.1 fails: k; U; i in 0..n; x | x = t[i] = t[i+k] < t[i+k+1] or t[i] < t[i+1] = t[m] = x : G[i](x) = 1 *)
Definition T3_5_1_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  ((x = t i /\ t i = t (i + k)%N /\ t (i + k)%N < t ((i + k).+1)%N) \/ (t i < t i.+1 /\ t i.+1 = t m /\ t m = x)) ->
  value r t m k i x = 1.
Definition T3_5_1_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  (i <= m)%N /\ (i <= n.+1)%N /\ (i <= n + k)%N.

(* T3.5.2 printed: k; U; i in 0..n; x in (t[i], t[i+k+1]) : G[i](x) > 0 *)
Definition T3_5_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t i < x < t ((i + k).+1)%N ->
  0 < value r t m k i x.
Definition T3_5_2_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  (i <= m)%N.

(* T3.5.3 printed: k; U; j in 0..m-1; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = sum(i in j-k..j: G[i](x)) = 1 *)
Definition T3_5_3_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  (\sum_(0 <= i < n.+1) value r t m k i x = \sum_(j - k <= i < j.+1) value r t m k i x /\ \sum_(j - k <= i < j.+1) value r t m k i x = 1).
Definition T3_5_3_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  (j <= m)%N /\ (forall x : R,
  t j <= x < t j.+1 ->
  (k <= j)%N /\ (forall i : nat, (j <= i + k)%N -> (i <= j)%N -> (i <= n)%N)).

(* T3.5.3 amended: k; U; j in k..n; x in [t[j], t[j+1]) : sum(i in 0..n: G[i](x)) = sum(i in j-k..j: G[i](x)) = 1 *)
Definition T3_5_3_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  (\sum_(0 <= i < n.+1) value r t m k i x = \sum_(j - k <= i < j.+1) value r t m k i x /\ \sum_(j - k <= i < j.+1) value r t m k i x = 1).
Definition T3_5_3_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  (j <= m)%N /\ (j <= n + k)%N /\ (forall x : R,
  t j <= x < t j.+1 ->
  (forall i : nat, (j <= i + k)%N -> (i <= j)%N -> (i <= n)%N)).

(* T3.5.3 fails: k; U; j in 0..m-1; x in (t[j], t[j+1]) | not j in k..n : sum(i in 0..n: G[i](x)) < 1 *)
Definition T3_5_3_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  forall x : R,
  t j < x < t j.+1 ->
  ~ ((k <= j)%N /\ (j <= n)%N) ->
  \sum_(0 <= i < n.+1) value r t m k i x < 1.
Definition T3_5_3_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  (j <= m)%N.

(* T3.5.4 printed: k; U symmetric; i in 0..n; x in [t[0], t[m]] : G[i](t[0] + t[m] - x) = G[n-i](x; alpha = 1 - alpha) *)
Definition T3_5_4_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  value r t m k i (t 0%N + t m - x) = value r^-1 t m k (n - i)%N x.

(* T3.5.4 amended: k; U symmetric; i in 0..n; x in [t[0], t[m]] | x = t[0] or x = t[m] or mult(x) <= k : G[i](t[0] + t[m] - x) = G[n-i](x; alpha = 1 - alpha) *)
Definition T3_5_4_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (x = t 0%N \/ x = t m \/ (mult t m x <= k)%N) ->
  value r t m k i (t 0%N + t m - x) = value r^-1 t m k (n - i)%N x.

(* T3.5.4 fails: k; U symmetric; x in (t[0], t[m]) | mult(x) > k : some(i in 0..n: G[i](t[0] + t[m] - x) != G[n-i](x; alpha = 1 - alpha)) *)
Definition T3_5_4_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall x : R,
  t 0%N < x < t m ->
  (k < mult t m x)%N ->
  (exists i : nat, (i <= n)%N /\ value r t m k i (t 0%N + t m - x) != value r^-1 t m k (n - i)%N x).

(* L3.6 printed: k; U open; q in 0..k-1 : G[q,k-q](t[0]) = G[q+1,k-q-1](t[0]); G[q+1,k-q](t[0]) = G[q+2,k-q-1](t[0]) *)
Definition L3_6_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  value r t m (k - q)%N q (t 0%N) = value r t m (k - q.+1)%N q.+1 (t 0%N) /\
  value r t m (k - q)%N q.+1 (t 0%N) = value r t m (k - q.+1)%N q.+2 (t 0%N).
Definition L3_6_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (q <= k)%N /\ (1 <= n)%N.

(* L3.7 printed: k; U open; q in 0..k-1 : G[n,k-q](t[m]-) = G[n,k-q-1](t[m]-); k >= 2 => G[n-1,k-q](t[m]-) = G[n-1,k-q-1](t[m]-) *)
Definition L3_7_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  Gleft r t m (k - q)%N n (t m) = Gleft r t m (k - q.+1)%N n (t m) /\
  ((2 <= k)%N -> Gleft r t m (k - q)%N (n - 1)%N (t m) = Gleft r t m (k - q.+1)%N (n - 1)%N (t m)).
Definition L3_7_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (q <= k)%N /\ ((2 <= k)%N -> (1 <= n)%N).

(* P3.1.1 printed: k; U; i in 0..n; j in 0..m-1 : rational(G[i](x), x in (t[j], t[j+1])) *)
Definition P3_1_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall j : nat,
  (j <= n + k)%N ->
  rational_on (t j) (t j.+1) (fun x => value r t m k i x).
Definition P3_1_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall j : nat,
  (j <= n + k)%N ->
  (j <= m)%N.

(* P3.1.2 printed: k; U interior; i in 0..n; x in [t[0], t[m]) | t[k] < t[m-k] : G[i](x+) = G[i](x); t[0] < x => G[i](x-) = G[i](x) *)
Definition P3_1_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uinterior t n k ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x < t m ->
  t k < t n.+1 ->
  Gright r t m k i x = value r t m k i x /\
  (t 0%N < x -> Gleft r t m k i x = value r t m k i x).

(* P3.1.3 printed: k; U open : G[0](t[0]) = 1; all(i in 1..n: G[i](t[0]) = 0); G[n](t[m]-) = 1; all(i in 0..n-1: G[i](t[m]-) = 0) *)
Definition P3_1_3_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  value r t m k 0%N (t 0%N) = 1 /\
  (forall i : nat, (1 <= i)%N -> (i <= n)%N -> value r t m k i (t 0%N) = 0) /\
  Gleft r t m k n (t m) = 1 /\
  (forall i : nat, (i.+1 <= n)%N -> Gleft r t m k i (t m) = 0).
Definition P3_1_3_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  (forall i : nat, (i.+1 <= n)%N -> (i <= n)%N).

(* P3.1.3 amended: k; U clamped : G[0](t[0]) = 1; all(i in 1..n: G[i](t[0]) = 0); G[n](t[m]-) = 1; all(i in 0..n-1: G[i](t[m]-) = 0) *)
Definition P3_1_3_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  value r t m k 0%N (t 0%N) = 1 /\
  (forall i : nat, (1 <= i)%N -> (i <= n)%N -> value r t m k i (t 0%N) = 0) /\
  Gleft r t m k n (t m) = 1 /\
  (forall i : nat, (i.+1 <= n)%N -> Gleft r t m k i (t m) = 0).
Definition P3_1_3_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  (forall i : nat, (i.+1 <= n)%N -> (i <= n)%N).

(* P3.1.3 fails: k; U open | t[k] = t[k+1] or t[n] = t[n+1] : G[0](t[0]) = 0 or G[n](t[m]-) = 0 *)
Definition P3_1_3_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  (t k = t k.+1 \/ t n = t n.+1) ->
  (value r t m k 0%N (t 0%N) = 0 \/ Gleft r t m k n (t m) = 0).

(* P3.1.extension printed: k; U; i in 0..n : defined(G[i](t[m]-)) *)
Definition P3_1_extension_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  (exists v l : R, left_taylor (G (wt r t) t k i) (t m) v l).

(* L3.8 printed: k; U open; q in 0..k-1 : G'[q,k-q](t[0]+) = G'[q+1,k-q-1](t[0]+) - w'[q+1,k-q](t[0]+); G'[q+1,k-q](t[0]+) = G'[q+2,k-q-1](t[0]+) + w'[q+1,k-q](t[0]+); all(i in 2..n: G'[q+i,k-q](t[0]+) = G'[q+i+1,k-q-1](t[0]+)) *)
Definition L3_8_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  DGright r t m (k - q)%N q (t 0%N) = DGright r t m (k - q.+1)%N q.+1 (t 0%N) - wDright r t (k - q)%N q.+1 (t 0%N) /\
  DGright r t m (k - q)%N q.+1 (t 0%N) = DGright r t m (k - q.+1)%N q.+2 (t 0%N) + wDright r t (k - q)%N q.+1 (t 0%N) /\
  (forall i : nat, (2 <= i)%N -> (i <= n)%N -> DGright r t m (k - q)%N (q + i)%N (t 0%N) = DGright r t m (k - q.+1)%N ((q + i).+1)%N (t 0%N)).
Definition L3_8_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (q <= k)%N /\ (1 <= n)%N.

(* L3.8 amended: k; U open; q in 0..k-1 | t[k] < t[k+1] : G'[q,k-q](t[0]+) = G'[q+1,k-q-1](t[0]+) - w'[q+1,k-q](t[0]+); G'[q+1,k-q](t[0]+) = G'[q+2,k-q-1](t[0]+) + w'[q+1,k-q](t[0]+); all(i in 2..n: G'[q+i,k-q](t[0]+) = G'[q+i+1,k-q-1](t[0]+)) *)
Definition L3_8_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  t k < t k.+1 ->
  DGright r t m (k - q)%N q (t 0%N) = DGright r t m (k - q.+1)%N q.+1 (t 0%N) - wDright r t (k - q)%N q.+1 (t 0%N) /\
  DGright r t m (k - q)%N q.+1 (t 0%N) = DGright r t m (k - q.+1)%N q.+2 (t 0%N) + wDright r t (k - q)%N q.+1 (t 0%N) /\
  (forall i : nat, (2 <= i)%N -> (i <= n)%N -> DGright r t m (k - q)%N (q + i)%N (t 0%N) = DGright r t m (k - q.+1)%N ((q + i).+1)%N (t 0%N)).
Definition L3_8_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  t k < t k.+1 ->
  (q <= k)%N /\ (1 <= n)%N.

(* L3.8 fails: k; U open; q in 0..k-1 | t[k] = t[k+1] : some(i in 1..n: G'[q+i,k-q](t[0]+) != G'[q+i+1,k-q-1](t[0]+)) *)
Definition L3_8_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  t k = t k.+1 ->
  (exists i : nat, (1 <= i)%N /\ (i <= n)%N /\ DGright r t m (k - q)%N (q + i)%N (t 0%N) != DGright r t m (k - q.+1)%N ((q + i).+1)%N (t 0%N)).
Definition L3_8_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  t k = t k.+1 ->
  (forall i : nat, (1 <= i)%N -> (i <= n)%N -> (q <= k)%N).

(* L3.9 printed: k; U open; q in 0..k-1 : G'[n,k-q](t[m]-) = G'[n,k-q-1](t[m]-) + w'[n,k-q](t[m]-); G'[n-1,k-q](t[m]-) = G'[n-1,k-q-1](t[m]-) - w'[n,k-q](t[m]-) *)
Definition L3_9_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  DGleft r t m (k - q)%N n (t m) = DGleft r t m (k - q.+1)%N n (t m) + wDleft r t (k - q)%N n (t m) /\
  DGleft r t m (k - q)%N (n - 1)%N (t m) = DGleft r t m (k - q.+1)%N (n - 1)%N (t m) - wDleft r t (k - q)%N n (t m).
Definition L3_9_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (q <= k)%N /\ (1 <= n)%N.

(* L3.9 amended: k; U open; q in 0..k-1 | mult(t[m]) != k + 2 : G'[n,k-q](t[m]-) = G'[n,k-q-1](t[m]-) + w'[n,k-q](t[m]-); G'[n-1,k-q](t[m]-) = G'[n-1,k-q-1](t[m]-) - w'[n,k-q](t[m]-) *)
Definition L3_9_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (mult t m (t m) != k.+2)%N ->
  DGleft r t m (k - q)%N n (t m) = DGleft r t m (k - q.+1)%N n (t m) + wDleft r t (k - q)%N n (t m) /\
  DGleft r t m (k - q)%N (n - 1)%N (t m) = DGleft r t m (k - q.+1)%N (n - 1)%N (t m) - wDleft r t (k - q)%N n (t m).
Definition L3_9_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (mult t m (t m) != k.+2)%N ->
  (q <= k)%N /\ (1 <= n)%N.

(* L3.9 fails: k; U open; q in 0..k-1 | mult(t[m]) = k + 2 : G'[n-1,k-q](t[m]-) != G'[n-1,k-q-1](t[m]-) - w'[n,k-q](t[m]-) *)
Definition L3_9_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (mult t m (t m) = k.+2)%N ->
  DGleft r t m (k - q)%N (n - 1)%N (t m) != DGleft r t m (k - q.+1)%N (n - 1)%N (t m) - wDleft r t (k - q)%N n (t m).
Definition L3_9_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall q : nat,
  (q.+1 <= k)%N ->
  (mult t m (t m) = k.+2)%N ->
  (q <= k)%N /\ (1 <= n)%N.

(* L3.10 printed: k >= 2; U open; i in 0..n-2 : G'[i](t[m]-) = 0 *)
Definition L3_10_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall i : nat,
  (i.+2 <= n)%N ->
  DGleft r t m k i (t m) = 0.
Definition L3_10_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall i : nat,
  (i.+2 <= n)%N ->
  (i <= n)%N.

(* L3.10 amended: k >= 2; U open; i in 0..n-2 | t[n] < t[n+1] : G'[i](t[m]-) = 0 *)
Definition L3_10_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall i : nat,
  (i.+2 <= n)%N ->
  t n < t n.+1 ->
  DGleft r t m k i (t m) = 0.
Definition L3_10_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall i : nat,
  (i.+2 <= n)%N ->
  t n < t n.+1 ->
  (i <= n)%N.

(* L3.10 fails: k >= 2; U open | t[n] = t[n+1] : some(i in 0..n-2: G'[i](t[m]-) != 0) *)
Definition L3_10_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t n = t n.+1 ->
  (exists i : nat, (i.+2 <= n)%N /\ DGleft r t m k i (t m) != 0).
Definition L3_10_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t n = t n.+1 ->
  (forall i : nat, (i.+2 <= n)%N -> (i <= n)%N).

(* T3.11.1 printed: k; U; i in 0..n; j in 0..m-1 : smooth(G[i](x), x in (t[j], t[j+1])) *)
Definition T3_11_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall j : nat,
  (j <= n + k)%N ->
  smooth (t j) (t j.+1) (fun x => value r t m k i x).
Definition T3_11_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall j : nat,
  (j <= n + k)%N ->
  (j <= m)%N.

(* T3.11.2 printed: k; U; i in 0..n; j in 0..m : t[0] < t[j] => defined(G'[i](t[j]-)) and G[i](t[j]-) = G[i](t[j]); t[j] < t[m] => defined(G'[i](t[j]+)) and G[i](t[j]+) = G[i](t[j]) *)
Definition T3_11_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall j : nat,
  (j <= m)%N ->
  (t 0%N < t j -> (exists v l : R, left_taylor (G (wt r t) t k i) (t j) v l) /\ Gleft r t m k i (t j) = value r t m k i (t j)) /\
  (t j < t m -> (exists v l : R, right_taylor (G (wt r t) t k i) (t j) v l) /\ Gright r t m k i (t j) = value r t m k i (t j)).

(* T3.11.2 amended: k; U; i in 0..n; j in 0..m : t[0] < t[j] => defined(G'[i](t[j]-)); t[j] < t[m] => defined(G'[i](t[j]+)) and G[i](t[j]+) = G[i](t[j]); t[0] < t[j] and (t[j] = t[m] or mult(t[j]) <= k) => G[i](t[j]-) = G[i](t[j]) *)
Definition T3_11_2_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall j : nat,
  (j <= m)%N ->
  (t 0%N < t j -> exists v l : R, left_taylor (G (wt r t) t k i) (t j) v l) /\
  (t j < t m -> (exists v l : R, right_taylor (G (wt r t) t k i) (t j) v l) /\ Gright r t m k i (t j) = value r t m k i (t j)) /\
  ((t 0%N < t j /\ (t j = t m \/ (mult t m (t j) <= k)%N)) -> Gleft r t m k i (t j) = value r t m k i (t j)).

(* T3.11.2 fails: k; U; j in 0..m | t[0] < t[j] < t[m]; mult(t[j]) > k : some(i in 0..n: G[i](t[j]-) != G[i](t[j])) *)
Definition T3_11_2_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= m)%N ->
  t 0%N < t j < t m ->
  (k < mult t m (t j))%N ->
  (exists i : nat, (i <= n)%N /\ Gleft r t m k i (t j) != value r t m k i (t j)).

(* T3.11.3a printed: k >= 1; U open : G'[1](t[0]+) = -G'[0](t[0]+) = k*r/(t[k+1] - t[0]); all(i in 2..n: G'[i](t[0]+) = 0) *)
Definition T3_11_3a_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  (DGright r t m k 1%N (t 0%N) = - DGright r t m k 0%N (t 0%N) /\ - DGright r t m k 0%N (t 0%N) = k%:R * r / (t k.+1 - t 0%N)) /\
  (forall i : nat, (2 <= i)%N -> (i <= n)%N -> DGright r t m k i (t 0%N) = 0).
Definition T3_11_3a_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  (1 <= n)%N /\ (t k.+1 - t 0%N) != 0 :> R.

(* T3.11.3a amended: k >= 1; U open | t[k] < t[k+1] : G'[1](t[0]+) = -G'[0](t[0]+) = k*r/(t[k+1] - t[0]); all(i in 2..n: G'[i](t[0]+) = 0) *)
Definition T3_11_3a_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t k < t k.+1 ->
  (DGright r t m k 1%N (t 0%N) = - DGright r t m k 0%N (t 0%N) /\ - DGright r t m k 0%N (t 0%N) = k%:R * r / (t k.+1 - t 0%N)) /\
  (forall i : nat, (2 <= i)%N -> (i <= n)%N -> DGright r t m k i (t 0%N) = 0).
Definition T3_11_3a_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t k < t k.+1 ->
  (1 <= n)%N /\ (t k.+1 - t 0%N) != 0 :> R.

(* T3.11.3a fails: k >= 1; U open | t[k] = t[k+1] : some(i in 2..n: G'[i](t[0]+) != 0) *)
Definition T3_11_3a_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t k = t k.+1 ->
  (exists i : nat, (2 <= i)%N /\ (i <= n)%N /\ DGright r t m k i (t 0%N) != 0).

(* T3.11.3b printed: k >= 1; U open : G'[n](t[m]-) = -G'[n-1](t[m]-) = k/(r*(t[m] - t[n])); all(i in 0..n-2: G'[i](t[m]-) = 0) *)
Definition T3_11_3b_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  (DGleft r t m k n (t m) = - DGleft r t m k (n - 1)%N (t m) /\ - DGleft r t m k (n - 1)%N (t m) = k%:R / (r * (t m - t n))) /\
  (forall i : nat, (i.+2 <= n)%N -> DGleft r t m k i (t m) = 0).
Definition T3_11_3b_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  (1 <= n)%N /\ (r * (t m - t n)) != 0 :> R /\ (forall i : nat, (i.+2 <= n)%N -> (i <= n)%N).

(* T3.11.3b amended: k >= 1; U open | t[n] < t[n+1] : G'[n](t[m]-) = -G'[n-1](t[m]-) = k/(r*(t[m] - t[n])); all(i in 0..n-2: G'[i](t[m]-) = 0) *)
Definition T3_11_3b_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t n < t n.+1 ->
  (DGleft r t m k n (t m) = - DGleft r t m k (n - 1)%N (t m) /\ - DGleft r t m k (n - 1)%N (t m) = k%:R / (r * (t m - t n))) /\
  (forall i : nat, (i.+2 <= n)%N -> DGleft r t m k i (t m) = 0).
Definition T3_11_3b_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t n < t n.+1 ->
  (1 <= n)%N /\ (r * (t m - t n)) != 0 :> R /\ (forall i : nat, (i.+2 <= n)%N -> (i <= n)%N).

(* T3.11.3b fails: k >= 1; U open | t[n] = t[n+1] : some(i in 0..n-2: G'[i](t[m]-) != 0) *)
Definition T3_11_3b_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t n = t n.+1 ->
  (exists i : nat, (i.+2 <= n)%N /\ DGleft r t m k i (t m) != 0).
Definition T3_11_3b_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  t n = t n.+1 ->
  (forall i : nat, (i.+2 <= n)%N -> (i <= n)%N).

(* Rem3.1 printed: k >= 2; U simple; i in 0..n | alpha != infinity : some(j in i+1..i+k: G'[i](t[j]-) != G'[i](t[j]+)) *)
Definition Rem3_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usimple t m ->
  forall i : nat,
  (i <= n)%N ->
  r != 1 ->
  (exists j : nat, (i.+1 <= j)%N /\ (j <= i + k)%N /\ DGleft r t m k i (t j) != DGright r t m k i (t j)).
Definition Rem3_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usimple t m ->
  forall i : nat,
  (i <= n)%N ->
  r != 1 ->
  (forall j : nat, (i.+1 <= j)%N -> (j <= i + k)%N -> (j <= m)%N).

(* Conj3.1.strong printed: no term of the theory says the word maxima *)

(* Conj3.1.strong amended: no term of the theory says the word maxima *)

(* Conj3.1.strong fails: no term of the theory says the word maxima *)

(* Conj3.1.weak printed: no term of the theory says the word maximisers *)

(* Conj3.1.weak amended: no term of the theory says the word maximisers *)

(* Conj3.1.weak fails: no term of the theory says the word maximisers *)

(* Conj3.1.strong.continuous printed: no term of the theory says the word continuous *)

(* Conj3.1.strong.continuous amended: no term of the theory says the word continuous *)

(* Conj3.1.weak.continuous printed: no term of the theory says the word continuous *)

(* Conj3.1.weak.continuous amended: no term of the theory says the word continuous *)

(* P3.2 printed: k; U open interior : rank(k) = n + 1 *)
Definition P3_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Uinterior t n k ->
  (forall c : nat -> R, (forall x : R, t 0%N <= x <= t m -> \sum_(0 <= i < n.+1) c i * value r t m k i x = 0) -> forall i : nat, (i < n.+1)%N -> c i = 0).

(* P3.3.1 printed: k >= 1; U bernstein; i in 0..k; x in [t[0], t[m]] : B[i,k](x) = phi(x, t[0], t[m])*B[i-1,k-1](x) + (1 - phi(x, t[0], t[m]))*B[i,k-1](x) *)
Definition P3_3_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  value r t m k i x = phi r x (t 0%N) (t m) * value r t m (k - 1)%N i x + (1 - phi r x (t 0%N) (t m)) * value r t m (k - 1)%N i.+1 x.
Definition P3_3_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (i <= n)%N /\ (i <= n.+1)%N.

(* P3.3.1 amended: k >= 1; U bernstein; i in 0..k; x in [t[0], t[m]) : B[i,k](x) = phi(x, t[0], t[m])*B[i-1,k-1](x) + (1 - phi(x, t[0], t[m]))*B[i,k-1](x) *)
Definition P3_3_1_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x < t m ->
  value r t m k i x = phi r x (t 0%N) (t m) * value r t m (k - 1)%N i x + (1 - phi r x (t 0%N) (t m)) * value r t m (k - 1)%N i.+1 x.
Definition P3_3_1_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x < t m ->
  (i <= n)%N /\ (i <= n.+1)%N.

(* P3.3.1 fails: k >= 1; U bernstein; i in k-1..k; x in [t[m], t[m]] : B[i,k](x) != phi(x, t[0], t[m])*B[i-1,k-1](x) + (1 - phi(x, t[0], t[m]))*B[i,k-1](x) *)
Definition P3_3_1_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (k <= i.+1)%N ->
  (i <= k)%N ->
  forall x : R,
  t m <= x <= t m ->
  value r t m k i x != phi r x (t 0%N) (t m) * value r t m (k - 1)%N i x + (1 - phi r x (t 0%N) (t m)) * value r t m (k - 1)%N i.+1 x.
Definition P3_3_1_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (k <= i.+1)%N ->
  (i <= k)%N ->
  forall x : R,
  t m <= x <= t m ->
  (i <= n)%N /\ (i <= n.+1)%N.

(* P3.3.2 printed: k; U bernstein; i in 0..k; x in [t[0], t[m]] : B[i,k](x) = binomial(k, i)*phi(x, t[0], t[m])^i*(1 - phi(x, t[0], t[m]))^(k-i) *)
Definition P3_3_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  value r t m k i x = ('C(k, i))%:R * (phi r x (t 0%N) (t m)) ^+ i * (1 - phi r x (t 0%N) (t m)) ^+ (k - i)%N.
Definition P3_3_2_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (i <= n)%N.

(* P3.3.2 amended: k; U bernstein; i in 0..k; x in [t[0], t[m]) : B[i,k](x) = binomial(k, i)*phi(x, t[0], t[m])^i*(1 - phi(x, t[0], t[m]))^(k-i) *)
Definition P3_3_2_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x < t m ->
  value r t m k i x = ('C(k, i))%:R * (phi r x (t 0%N) (t m)) ^+ i * (1 - phi r x (t 0%N) (t m)) ^+ (k - i)%N.
Definition P3_3_2_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t 0%N <= x < t m ->
  (i <= n)%N.

(* P3.3.2 fails: k >= 1; U bernstein; i in 0..k; x in [t[m], t[m]] | i = 0 or i = k : B[i,k](x) != binomial(k, i)*phi(x, t[0], t[m])^i*(1 - phi(x, t[0], t[m]))^(k-i) *)
Definition P3_3_2_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t m <= x <= t m ->
  ((i = 0)%N \/ (i = k)%N) ->
  value r t m k i x != ('C(k, i))%:R * (phi r x (t 0%N) (t m)) ^+ i * (1 - phi r x (t 0%N) (t m)) ^+ (k - i)%N.
Definition P3_3_2_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall i : nat,
  (i <= k)%N ->
  forall x : R,
  t m <= x <= t m ->
  ((i = 0)%N \/ (i = k)%N) ->
  (i <= n)%N.

(* P4.1.1 printed: k; U open; d points; j in 0..n; x in [t[0], t[m]] | not x in [t[j], t[j+k+1]) : C(x) = sum(i in 0..j-1: d[i]*G[i](x)) + sum(i in j+1..n: d[i]*G[i](x)) *)
Definition P4_1_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  ~ (t j <= x < t ((j + k).+1)%N) ->
  \sum_(0 <= i < n.+1) d i * value r t m k i x = \sum_(0 <= i < j) d i * value r t m k i x + (\sum_(j.+1 <= i < n.+1) d i * value r t m k i x).
Definition P4_1_1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (j <= m)%N /\ (~ (t j <= x < t ((j + k).+1)%N) ->
  (forall i : nat, (i.+1 <= j)%N -> (i <= n)%N)).

(* P4.1.1 amended: k; U open; d points; j in 0..n; x in [t[0], t[m]] | not x in [t[j], t[j+k+1]); not t[j] < t[j+1] = x = t[m] : C(x) = sum(i in 0..j-1: d[i]*G[i](x)) + sum(i in j+1..n: d[i]*G[i](x)) *)
Definition P4_1_1_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  ~ (t j <= x < t ((j + k).+1)%N) ->
  ~ (t j < t j.+1 /\ t j.+1 = x /\ x = t m) ->
  \sum_(0 <= i < n.+1) d i * value r t m k i x = \sum_(0 <= i < j) d i * value r t m k i x + (\sum_(j.+1 <= i < n.+1) d i * value r t m k i x).
Definition P4_1_1_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (j <= m)%N /\ (~ (t j <= x < t ((j + k).+1)%N) ->
  (j <= n + k)%N /\ (~ (t j < t j.+1 /\ t j.+1 = x /\ x = t m) ->
  (forall i : nat, (i.+1 <= j)%N -> (i <= n)%N))).

(* P4.1.1 fails: k; U open; d points; j in 0..n; x in [t[0], t[m]] | t[j] < t[j+1] = x = t[m] : C(x) = d[j] *)
Definition P4_1_1_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (t j < t j.+1 /\ t j.+1 = x /\ x = t m) ->
  \sum_(0 <= i < n.+1) d i * value r t m k i x = d j.
Definition P4_1_1_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (j <= m)%N /\ (j <= n + k)%N.

(* P4.1.2 printed: k; U open; d points; j in k..n; x in [t[j], t[j+1]) : C(x) = sum(i in j-k..j: d[i]*G[i](x)) *)
Definition P4_1_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  \sum_(0 <= i < n.+1) d i * value r t m k i x = \sum_(j - k <= i < j.+1) d i * value r t m k i x.
Definition P4_1_2_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  (j <= m)%N /\ (j <= n + k)%N /\ (forall x : R,
  t j <= x < t j.+1 ->
  (forall i : nat, (j <= i + k)%N -> (i <= j)%N -> (i <= n)%N)).

(* P4.1.3 printed: k; U open; x in [t[0], t[m]] : all(i in 0..n: 0 <= G[i](x)); sum(i in 0..n: G[i](x)) = 1 *)
Definition P4_1_3_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall x : R,
  t 0%N <= x <= t m ->
  (forall i : nat, (i <= n)%N -> 0 <= value r t m k i x) /\
  \sum_(0 <= i < n.+1) value r t m k i x = 1.

(* P4.1.4 printed: k; U open; d points; c; x in [t[0], t[m]] : C(x) + c = sum(i in 0..n: (d[i] + c)*G[i](x)) *)
Definition P4_1_4_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall c : R,
  forall x : R,
  t 0%N <= x <= t m ->
  \sum_(0 <= i < n.+1) d i * value r t m k i x + c = \sum_(0 <= i < n.+1) (d i + c) * value r t m k i x.

(* P4.2.1 printed: k; U open; d points : C(t[0]) = d[0]; C(t[m]) = d[n] *)
Definition P4_2_1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  \sum_(0 <= i < n.+1) d i * value r t m k i (t 0%N) = d 0%N /\
  \sum_(0 <= i < n.+1) d i * value r t m k i (t m) = d n.

(* P4.2.1 amended: k; U clamped; d points : C(t[0]) = d[0]; C(t[m]) = d[n] *)
Definition P4_2_1_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  forall d : nat -> R,
  \sum_(0 <= i < n.+1) d i * value r t m k i (t 0%N) = d 0%N /\
  \sum_(0 <= i < n.+1) d i * value r t m k i (t m) = d n.

(* P4.2.1 fails: k; U open; d points; p in 1..n : t[0] = t[k+p] < t[k+p+1] => C(t[0]) = d[p]; t[n-p] < t[n-p+1] = t[m] => C(t[m]) = d[n-p] *)
Definition P4_2_1_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall p : nat,
  (1 <= p)%N ->
  (p <= n)%N ->
  ((t 0%N = t (k + p)%N /\ t (k + p)%N < t ((k + p).+1)%N) -> \sum_(0 <= i < n.+1) d i * value r t m k i (t 0%N) = d p) /\
  ((t (n - p)%N < t (n.+1 - p)%N /\ t (n.+1 - p)%N = t m) -> \sum_(0 <= i < n.+1) d i * value r t m k i (t m) = d (n - p)%N).
Definition P4_2_1_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall p : nat,
  (1 <= p)%N ->
  (p <= n)%N ->
  (p <= n.+1)%N.

(* P4.2.2 printed: k >= 1; U open; d points : C'(t[0]+) = k*r/(t[k+1] - t[0])*(d[1] - d[0]); C'(t[m]-) = k/(r*(t[m] - t[n]))*(d[n] - d[n-1]) *)
Definition P4_2_2_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  \sum_(0 <= i < n.+1) d i * DGright r t m k i (t 0%N) = k%:R * r / (t k.+1 - t 0%N) * (d 1%N - d 0%N) /\
  \sum_(0 <= i < n.+1) d i * DGleft r t m k i (t m) = k%:R / (r * (t m - t n)) * (d n - d (n - 1)%N).
Definition P4_2_2_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  (t k.+1 - t 0%N) != 0 :> R /\ (1 <= n)%N /\ (r * (t m - t n)) != 0 :> R.

(* P4.2.2 amended: k >= 1; U clamped; d points : C'(t[0]+) = k*r/(t[k+1] - t[0])*(d[1] - d[0]); C'(t[m]-) = k/(r*(t[m] - t[n]))*(d[n] - d[n-1]) *)
Definition P4_2_2_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  forall d : nat -> R,
  \sum_(0 <= i < n.+1) d i * DGright r t m k i (t 0%N) = k%:R * r / (t k.+1 - t 0%N) * (d 1%N - d 0%N) /\
  \sum_(0 <= i < n.+1) d i * DGleft r t m k i (t m) = k%:R / (r * (t m - t n)) * (d n - d (n - 1)%N).
Definition P4_2_2_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  forall d : nat -> R,
  (t k.+1 - t 0%N) != 0 :> R /\ (1 <= n)%N /\ (r * (t m - t n)) != 0 :> R.

(* P4.2.2 fails: k >= 1; U open; d points; p in 1..n-1 : t[0] = t[k+p] < t[k+p+1] => C'(t[0]+) = k*r/(t[k+p+1] - t[0])*(d[p+1] - d[p]); t[n-p] < t[n-p+1] = t[m] => C'(t[m]-) = k/(r*(t[m] - t[n-p]))*(d[n-p] - d[n-p-1]) *)
Definition P4_2_2_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall p : nat,
  (1 <= p)%N ->
  (p.+1 <= n)%N ->
  ((t 0%N = t (k + p)%N /\ t (k + p)%N < t ((k + p).+1)%N) -> \sum_(0 <= i < n.+1) d i * DGright r t m k i (t 0%N) = k%:R * r / (t ((k + p).+1)%N - t 0%N) * (d p.+1 - d p)) /\
  ((t (n - p)%N < t (n.+1 - p)%N /\ t (n.+1 - p)%N = t m) -> \sum_(0 <= i < n.+1) d i * DGleft r t m k i (t m) = k%:R / (r * (t m - t (n - p)%N)) * (d (n - p)%N - d (n - p.+1)%N)).
Definition P4_2_2_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall d : nat -> R,
  forall p : nat,
  (1 <= p)%N ->
  (p.+1 <= n)%N ->
  (p <= n.+1)%N /\ (p <= n)%N /\ ((t 0%N = t (k + p)%N /\ t (k + p)%N < t ((k + p).+1)%N) -> (t ((k + p).+1)%N - t 0%N) != 0 :> R) /\ ((t (n - p)%N < t (n.+1 - p)%N /\ t (n.+1 - p)%N = t m) -> (r * (t m - t (n - p)%N)) != 0 :> R).

(* P4.2.tangent printed: k >= 1; U clamped; d points | some(i in 1..n: d[i] != d[0]) : C'(t[0]+) != 0; C'(t[m]-) != 0 *)
Definition P4_2_tangent_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  forall d : nat -> R,
  (exists i : nat, (1 <= i)%N /\ (i <= n)%N /\ d i != d 0%N) ->
  \sum_(0 <= i < n.+1) d i * DGright r t m k i (t 0%N) != 0 /\
  \sum_(0 <= i < n.+1) d i * DGleft r t m k i (t m) != 0.

(* P4.2.tangent amended: no term of the theory says a derivative that is not one of order 1 from one side *)

(* P4.3 printed: k; U open symmetric; d points; x in [t[0], t[m]] : C(t[0] + t[m] - x) = R(x; alpha = 1 - alpha) *)
Definition P4_3_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Usymmetric t n k ->
  forall d : nat -> R,
  forall x : R,
  t 0%N <= x <= t m ->
  \sum_(0 <= i < n.+1) d i * value r t m k i (t 0%N + t m - x) = \sum_(0 <= i < n.+1) d (n - i)%N * value r^-1 t m k i x.

(* P4.3 amended: k; U open symmetric; d points; x in [t[0], t[m]] | x = t[0] or x = t[m] or mult(x) <= k : C(t[0] + t[m] - x) = R(x; alpha = 1 - alpha) *)
Definition P4_3_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Usymmetric t n k ->
  forall d : nat -> R,
  forall x : R,
  t 0%N <= x <= t m ->
  (x = t 0%N \/ x = t m \/ (mult t m x <= k)%N) ->
  \sum_(0 <= i < n.+1) d i * value r t m k i (t 0%N + t m - x) = \sum_(0 <= i < n.+1) d (n - i)%N * value r^-1 t m k i x.

(* P4.3 fails: k; U open symmetric; x in (t[0], t[m]) | mult(x) > k : some(i in 0..n: G[i](t[0] + t[m] - x) != G[n-i](x; alpha = 1 - alpha)) *)
Definition P4_3_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Usymmetric t n k ->
  forall x : R,
  t 0%N < x < t m ->
  (k < mult t m x)%N ->
  (exists i : nat, (i <= n)%N /\ value r t m k i (t 0%N + t m - x) != value r^-1 t m k (n - i)%N x).

(* T4.1 printed: no term of the theory says the recursion of b *)

(* T4.1.range printed: no term of the theory says the recursion of b *)

(* T4.1.range amended: no term of the theory says the recursion of b *)

(* C6.classical printed: no term of the theory says the sentence T3.5.1 *)

(* C6.classical amended: no term of the theory says the sentence T3.5.1 *)

(* proof.T3.5.2.cover printed: k >= 1; U; i in 0..n; x in [t[0], t[m]] : x in (t[i], t[i+k]) or x in (t[i+1], t[i+k+1]) <=> x in (t[i], t[i+k+1]) *)
Definition proof_T3_5_2_cover_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  ((t i < x < t (i + k)%N \/ t i.+1 < x < t ((i + k).+1)%N) <-> t i < x < t ((i + k).+1)%N).
Definition proof_T3_5_2_cover_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (i <= m)%N /\ (i <= n.+1)%N /\ (i <= n + k)%N.

(* proof.T3.5.2.cover amended: k >= 1; U; i in 0..n; x in [t[0], t[m]] | not t[i] < t[i+1] = t[i+k] < t[i+k+1] : x in (t[i], t[i+k]) or x in (t[i+1], t[i+k+1]) <=> x in (t[i], t[i+k+1]) *)
Definition proof_T3_5_2_cover_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  ~ (t i < t i.+1 /\ t i.+1 = t (i + k)%N /\ t (i + k)%N < t ((i + k).+1)%N) ->
  ((t i < x < t (i + k)%N \/ t i.+1 < x < t ((i + k).+1)%N) <-> t i < x < t ((i + k).+1)%N).
Definition proof_T3_5_2_cover_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (i <= m)%N /\ (i <= n + k)%N /\ (i <= n.+1)%N.

(* proof.T3.5.2.cover fails: k >= 1; U; i in 0..n; x in [t[0], t[m]] | t[i] < t[i+1] = t[i+k] < t[i+k+1] : x in (t[i], t[i+k]) or x in (t[i+1], t[i+k+1]) <=> x in (t[i], t[i+k+1]) and x != t[i+1] *)
Definition proof_T3_5_2_cover_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (t i < t i.+1 /\ t i.+1 = t (i + k)%N /\ t (i + k)%N < t ((i + k).+1)%N) ->
  ((t i < x < t (i + k)%N \/ t i.+1 < x < t ((i + k).+1)%N) <-> (t i < x < t ((i + k).+1)%N /\ x != t i.+1)).
Definition proof_T3_5_2_cover_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (i <= m)%N /\ (i <= n + k)%N /\ (i <= n.+1)%N.

(* proof.P4.1.1.iff printed: k; U; j in 0..n; x : G[j](x) != 0 <=> x in (t[j], t[j+k+1]) *)
Definition proof_P4_1_1_iff_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  (value r t m k j x != 0 <-> t j < x < t ((j + k).+1)%N).
Definition proof_P4_1_1_iff_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  (j <= m)%N.

(* proof.P4.1.1.iff amended: k; U; j in 0..n; x | not x = t[j] = t[j+k] < t[j+k+1]; not t[j] < t[j+1] = x = t[m] : G[j](x) != 0 <=> x in (t[j], t[j+k+1]) *)
Definition proof_P4_1_1_iff_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  ~ (x = t j /\ t j = t (j + k)%N /\ t (j + k)%N < t ((j + k).+1)%N) ->
  ~ (t j < t j.+1 /\ t j.+1 = x /\ x = t m) ->
  (value r t m k j x != 0 <-> t j < x < t ((j + k).+1)%N).
Definition proof_P4_1_1_iff_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  (j <= m)%N /\ (j <= n.+1)%N /\ (~ (x = t j /\ t j = t (j + k)%N /\ t (j + k)%N < t ((j + k).+1)%N) ->
  (j <= n + k)%N).

(* proof.P4.1.1.iff fails: k; U; j in 0..n; x | x = t[j] = t[j+k] < t[j+k+1] or t[j] < t[j+1] = x = t[m] : G[j](x) = 1 *)
Definition proof_P4_1_1_iff_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  ((x = t j /\ t j = t (j + k)%N /\ t (j + k)%N < t ((j + k).+1)%N) \/ (t j < t j.+1 /\ t j.+1 = x /\ x = t m)) ->
  value r t m k j x = 1.
Definition proof_P4_1_1_iff_fails_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n)%N ->
  forall x : R,
  (j <= m)%N /\ (j <= n.+1)%N /\ (j <= n + k)%N.

(* proof.P3.2.induction amended: no term of the theory says a derivative that is not one of order 1 from one side *)

(* proof.T3.5.3.iff printed: k; U; j in 0..m-1; i in 0..n; x in [t[j], t[j+1]) : G[i](x) != 0 <=> i in j-k..j *)
Definition proof_T3_5_3_iff_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  (value r t m k i x != 0 <-> ((j <= i + k)%N /\ (i <= j)%N)).
Definition proof_T3_5_3_iff_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  (j <= m)%N.

(* proof.T3.5.3.iff amended: k; U; j in 0..m-1; i in 0..n; x in [t[j], t[j+1]) : G[i](x) != 0 <=> i in j-k..j and (x > t[j] or t[i] < t[j] or i = j - k) *)
Definition proof_T3_5_3_iff_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  (value r t m k i x != 0 <-> (((j <= i + k)%N /\ (i <= j)%N) /\ (t j < x \/ t i < t j \/ (k + i = j)%N))).
Definition proof_T3_5_3_iff_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  (j <= m)%N /\ (forall x : R,
  t j <= x < t j.+1 ->
  (i <= m)%N).

(* proof.P4.1.2.iff printed: k; U open; j in 0..m-1; i in 0..n; x in [t[j], t[j+1]) : G[i](x) != 0 <=> i in j-k..j *)
Definition proof_P4_1_2_iff_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  (value r t m k i x != 0 <-> ((j <= i + k)%N /\ (i <= j)%N)).
Definition proof_P4_1_2_iff_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  (j <= m)%N.

(* proof.P4.1.2.iff amended: k; U open; j in 0..m-1; i in 0..n; x in [t[j], t[j+1]) : G[i](x) != 0 <=> i in j-k..j and (x > t[j] or t[i] < t[j] or i = j - k) *)
Definition proof_P4_1_2_iff_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  (value r t m k i x != 0 <-> (((j <= i + k)%N /\ (i <= j)%N) /\ (t j < x \/ t i < t j \/ (k + i = j)%N))).
Definition proof_P4_1_2_iff_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (j <= n + k)%N ->
  forall i : nat,
  (i <= n)%N ->
  (j <= m)%N /\ (forall x : R,
  t j <= x < t j.+1 ->
  (i <= m)%N).

(* proof.P3.1.2.induction printed: k >= 2; U interior; i in 0..n+1; x in (t[0], t[m]) | t[k] < t[m-k] : G[i,k-1](x-) = G[i,k-1](x) *)
Definition proof_P3_1_2_induction_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uinterior t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N < x < t m ->
  t k < t n.+1 ->
  Gleft r t m (k - 1)%N i x = value r t m (k - 1)%N i x.
Definition proof_P3_1_2_induction_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uinterior t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N < x < t m ->
  t k < t n.+1 ->
  (1 <= k)%N.

(* proof.P3.1.2.induction amended: k >= 2; U interior; i in 0..n+1; x in (t[0], t[m]) | t[k] < t[m-k] : t[i+1] = x = t[i+k] => G[i,k-1](x-) = 1 and G[i,k-1](x) = 0; t[i] = x = t[i+k-1] => G[i,k-1](x-) = 0 and G[i,k-1](x) = 1; t[i+1] = x = t[i+k] or t[i] = x = t[i+k-1] or G[i,k-1](x-) = G[i,k-1](x); i <= n => G[i](x-) = G[i](x) *)
Definition proof_P3_1_2_induction_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uinterior t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N < x < t m ->
  t k < t n.+1 ->
  ((t i.+1 = x /\ x = t (i + k)%N) -> Gleft r t m (k - 1)%N i x = 1 /\ value r t m (k - 1)%N i x = 0) /\
  ((t i = x /\ x = t (i + k - 1)%N) -> Gleft r t m (k - 1)%N i x = 0 /\ value r t m (k - 1)%N i x = 1) /\
  ((t i.+1 = x /\ x = t (i + k)%N) \/ (t i = x /\ x = t (i + k - 1)%N) \/ Gleft r t m (k - 1)%N i x = value r t m (k - 1)%N i x) /\
  ((i <= n)%N -> Gleft r t m k i x = value r t m k i x).
Definition proof_P3_1_2_induction_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uinterior t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N < x < t m ->
  t k < t n.+1 ->
  (i <= n + k)%N /\ ((t i.+1 = x /\ x = t (i + k)%N) -> (1 <= k)%N) /\ (i <= m)%N /\ (i <= n.+2)%N /\ (1 <= i + k)%N /\ ((t i = x /\ x = t (i + k - 1)%N) -> (1 <= k)%N) /\ (1 <= k)%N.

(* proof.P3.2.hypothesis printed: k >= 2; U open interior : rank(k - 1) = n + 2 *)
Definition proof_P3_2_hypothesis_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Uinterior t n k ->
  (forall c : nat -> R, (forall x : R, t 0%N <= x <= t m -> \sum_(0 <= i < n.+2) c i * value r t m (k - 1)%N i x = 0) -> forall i : nat, (i < n.+2)%N -> c i = 0).
Definition proof_P3_2_hypothesis_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Uinterior t n k ->
  (1 <= k)%N.

(* proof.P3.2.hypothesis amended: no term of the theory says a dimension below the number of functions *)

(* proof.T3.5.4.base printed: k = 0; U symmetric; x in [t[0], t[m]]; i in 0..n : G[i](t[0] + t[m] - x) = G[n-i](x; alpha = 1 - alpha) *)
Definition proof_T3_5_4_base_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (k <= 0)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall x : R,
  t 0%N <= x <= t m ->
  forall i : nat,
  (i <= n)%N ->
  value r t m k i (t 0%N + t m - x) = value r^-1 t m k (n - i)%N x.

(* proof.T3.5.4.base amended: k = 0; U symmetric; x in [t[0], t[m]]; i in 0..n | x = t[0] or x = t[m] or mult(x) = 0 : G[i](t[0] + t[m] - x) = G[n-i](x; alpha = 1 - alpha) *)
Definition proof_T3_5_4_base_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (k <= 0)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall x : R,
  t 0%N <= x <= t m ->
  forall i : nat,
  (i <= n)%N ->
  (x = t 0%N \/ x = t m \/ (mult t m x = 0)%N) ->
  value r t m k i (t 0%N + t m - x) = value r^-1 t m k (n - i)%N x.

(* proof.T3.5.4.base fails: k = 0; U symmetric; x in (t[0], t[m]) | mult(x) > 0 : some(i in 0..n: G[i](t[0] + t[m] - x) != G[n-i](x; alpha = 1 - alpha)) *)
Definition proof_T3_5_4_base_fails : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (k <= 0)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall x : R,
  t 0%N < x < t m ->
  (0 < mult t m x)%N ->
  (exists i : nat, (i <= n)%N /\ value r t m k i (t 0%N + t m - x) != value r^-1 t m k (n - i)%N x).

(* proof.T3.5.4.corollary printed: k >= 1; U symmetric; i in 0..n+1; x in [t[0], t[m]] : phi(t[0] + t[m] - x, t[i], t[i+k]) = 1 - phi(x, t[m-i-k], t[m-i]; alpha = 1 - alpha) *)
Definition proof_T3_5_4_corollary_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  phi r (t 0%N + t m - x) (t i) (t (i + k)%N) = 1 - phi r^-1 x (t (n.+1 - i)%N) (t (m - i)%N).
Definition proof_T3_5_4_corollary_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (i <= m)%N.

(* proof.T3.5.4.corollary amended: k >= 1; U symmetric; i in 0..n+1; x in [t[0], t[m]] | mult(x) = 0 : phi(t[0] + t[m] - x, t[i], t[i+k])*G[i,k-1](t[0] + t[m] - x) = (1 - phi(x, t[m-i-k], t[m-i]; alpha = 1 - alpha))*G[m-k-i,k-1](x; alpha = 1 - alpha) *)
Definition proof_T3_5_4_corollary_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (mult t m x = 0)%N ->
  phi r (t 0%N + t m - x) (t i) (t (i + k)%N) * value r t m (k - 1)%N i (t 0%N + t m - x) = (1 - phi r^-1 x (t (n.+1 - i)%N) (t (m - i)%N)) * value r^-1 t m (k - 1)%N (n.+1 - i)%N x.
Definition proof_T3_5_4_corollary_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Usymmetric t n k ->
  forall i : nat,
  (i <= n.+1)%N ->
  forall x : R,
  t 0%N <= x <= t m ->
  (mult t m x = 0)%N ->
  (i <= m)%N.

(* proof.P4.3.bisector amended: k; U open symmetric interior; d points : all(x in [t[0], t[m]]: C(x; alpha = 1 - alpha) = sum(i in 0..n: d[n-i]*G[i](t[0] + t[m] - x))); rank(k) = n + 1 *)
Definition proof_P4_3_bisector_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  Usymmetric t n k ->
  Uinterior t n k ->
  forall d : nat -> R,
  (forall x : R, t 0%N <= x <= t m -> \sum_(0 <= i < n.+1) d i * value r^-1 t m k i x = \sum_(0 <= i < n.+1) d (n - i)%N * value r t m k i (t 0%N + t m - x)) /\
  (forall c : nat -> R, (forall x : R, t 0%N <= x <= t m -> \sum_(0 <= i < n.+1) c i * value r t m k i x = 0) -> forall i : nat, (i < n.+1)%N -> c i = 0).

(* X.G1 printed: k >= 2; U open; j in k+1..n; p in 0..n; q in 0..n | alpha != infinity; t[j-1] < t[j] < t[j+1] : G'[p](t[j]-)*G'[q](t[j]+) = G'[q](t[j]-)*G'[p](t[j]+); G'[p](t[j]-)*G'[p](t[j]+) > 0 or G'[p](t[j]-) = G'[p](t[j]+) = 0 *)
Definition X_G1_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (k.+1 <= j)%N ->
  (j <= n)%N ->
  forall p : nat,
  (p <= n)%N ->
  forall q : nat,
  (q <= n)%N ->
  r != 1 ->
  t (j - 1)%N < t j < t j.+1 ->
  DGleft r t m k p (t j) * DGright r t m k q (t j) = DGleft r t m k q (t j) * DGright r t m k p (t j) /\
  (0 < DGleft r t m k p (t j) * DGright r t m k p (t j) \/ (DGleft r t m k p (t j) = DGright r t m k p (t j) /\ DGright r t m k p (t j) = 0)).
Definition X_G1_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (k.+1 <= j)%N ->
  (j <= n)%N ->
  forall p : nat,
  (p <= n)%N ->
  forall q : nat,
  (q <= n)%N ->
  r != 1 ->
  (j <= (n + k).+2)%N /\ (1 <= j)%N /\ (j <= m)%N /\ (j <= n + k)%N.

(* X.G1 amended: k >= 2; U open; j in k+1..n | alpha != infinity; t[j-1] < t[j] < t[j+1] : all(p in 0..n: all(q in 0..n: G'[p](t[j]-)*G'[q](t[j]+) = G'[q](t[j]-)*G'[p](t[j]+)) and (G'[p](t[j]-)*G'[p](t[j]+) > 0 or G'[p](t[j]-) = G'[p](t[j]+) = 0)) <=> t[j-k+1] = t[j-1] and t[j+1] = t[j+k-1] *)
Definition X_G1_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (k.+1 <= j)%N ->
  (j <= n)%N ->
  r != 1 ->
  t (j - 1)%N < t j < t j.+1 ->
  ((forall p : nat, (p <= n)%N -> (forall q : nat, (q <= n)%N -> DGleft r t m k p (t j) * DGright r t m k q (t j) = DGleft r t m k q (t j) * DGright r t m k p (t j)) /\ (0 < DGleft r t m k p (t j) * DGright r t m k p (t j) \/ (DGleft r t m k p (t j) = DGright r t m k p (t j) /\ DGright r t m k p (t j) = 0))) <-> (t (j.+1 - k)%N = t (j - 1)%N /\ t j.+1 = t (j + k - 1)%N)).
Definition X_G1_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (2 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uopen t n k ->
  forall j : nat,
  (k.+1 <= j)%N ->
  (j <= n)%N ->
  r != 1 ->
  (j <= (n + k).+2)%N /\ (1 <= j)%N /\ (j <= m)%N /\ (j <= n + k)%N /\ (t (j - 1)%N < t j < t j.+1 ->
  (j <= n + k + k)%N /\ (k <= j.+1)%N /\ (j <= n.+2)%N /\ (1 <= j + k)%N).

(* X.variation printed: no term of the theory says the word changes *)

(* X.totalpositivity printed: no term of the theory says the word totally_positive *)

(* X.monotone printed: k >= 1; U; l in k..n; j in l-k+1..l; x in (t[l], t[l+1]) : sum(i in j..n: G'[i](x+)) > 0 *)
Definition X_monotone_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall l : nat,
  (k <= l)%N ->
  (l <= n)%N ->
  forall j : nat,
  (l.+1 <= j + k)%N ->
  (j <= l)%N ->
  forall x : R,
  t l < x < t l.+1 ->
  0 < \sum_(j <= i < n.+1) DGright r t m k i x.
Definition X_monotone_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall l : nat,
  (k <= l)%N ->
  (l <= n)%N ->
  (k <= l.+1)%N /\ (forall j : nat,
  (l.+1 <= j + k)%N ->
  (j <= l)%N ->
  (l <= m)%N /\ (l <= n + k)%N).

(* X.minors printed: k >= 1; U; l in 0..m-1; i in 0..n-1; x in (t[l], t[l+1]) : G[i](x)*G'[i+1](x+) >= G'[i](x+)*G[i+1](x) *)
Definition X_minors_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall l : nat,
  (l <= n + k)%N ->
  forall i : nat,
  (i.+1 <= n)%N ->
  forall x : R,
  t l < x < t l.+1 ->
  DGright r t m k i x * value r t m k i.+1 x <= value r t m k i x * DGright r t m k i.+1 x.
Definition X_minors_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall l : nat,
  (l <= n + k)%N ->
  forall i : nat,
  (i.+1 <= n)%N ->
  (l <= m)%N /\ (forall x : R,
  t l < x < t l.+1 ->
  (i <= n)%N).

(* X.linear printed: no term of the theory says the word combination *)

(* X.linear amended: no term of the theory says the word combination *)

(* X.nested printed: no term of the theory says the word nested *)

(* X.nested amended: no term of the theory says the word nested *)

(* X.derivative printed: no term of the theory says the word combination *)

(* X.derivative amended: no term of the theory says a derivative that is not one of order 1 from one side *)

(* X.nurbs printed: no term of the theory says the word nurbs_degree *)

(* X.maxima printed: no term of the theory says knots by their gaps *)

(* X.maxima.spans printed: no term of the theory says the word valleys *)

(* X.maxima.bound printed: no term of the theory says the word continuous *)

(* X.maxima.uniform printed: no term of the theory says the word maxima *)

(* X.maxima.most printed: no term of the theory says knots by their gaps *)

(* X.maxima.classical printed: no term of the theory says the word continuous *)

(* X.close printed: no term of the theory says a root *)

(* X.order printed: k >= 1; U; s > 0; l in k..n; j in l-k..l-1; x in (t[l], t[l+1]) : sum(i in 0..j: G[i](x; r = r + s)) < sum(i in 0..j: G[i](x)) *)
Definition X_order_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall s : R,
  0 < s ->
  forall l : nat,
  (k <= l)%N ->
  (l <= n)%N ->
  forall j : nat,
  (l <= j + k)%N ->
  (j.+1 <= l)%N ->
  forall x : R,
  t l < x < t l.+1 ->
  \sum_(0 <= i < j.+1) value (r + s) t m k i x < \sum_(0 <= i < j.+1) value r t m k i x.
Definition X_order_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall s : R,
  0 < s ->
  forall l : nat,
  (k <= l)%N ->
  (l <= n)%N ->
  forall j : nat,
  (l <= j + k)%N ->
  (j.+1 <= l)%N ->
  (l <= m)%N /\ (l <= n + k)%N /\ (forall x : R,
  t l < x < t l.+1 ->
  (forall i : nat, (i <= j)%N -> (i <= n)%N)).

(* X.limit printed: k >= 1; U; j in k..n; x in (t[j], t[j+1]) : 1 - G[j-k](x) <= r*sum(i in j-k+1..j: (x - t[i])/(t[j+1] - x)); 1 - G[j](x) <= 1/r*sum(i in j+1..j+k: (t[i] - x)/(x - t[j])) *)
Definition X_limit_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  forall x : R,
  t j < x < t j.+1 ->
  1 - value r t m k (j - k)%N x <= r * (\sum_(j.+1 - k <= i < j.+1) (x - t i) / (t j.+1 - x)) /\
  1 - value r t m k j x <= 1 / r * (\sum_(j.+1 <= i < (j + k).+1) (t i - x) / (x - t j)).
Definition X_limit_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  (j <= m)%N /\ (j <= n + k)%N /\ (forall x : R,
  t j < x < t j.+1 ->
  (k <= j.+1)%N /\ (forall i : nat, (j.+1 <= i + k)%N -> (i <= j)%N -> (i <= m)%N /\ (t j.+1 - x) != 0 :> R) /\ r != 0 :> R /\ (forall i : nat, (j.+1 <= i)%N -> (i <= j + k)%N -> (i <= m)%N /\ (x - t j) != 0 :> R)).

(* X.limit.trace printed: k >= 1; U; j in k..n; p in 1..k; x in [t[j], t[j+1]) : p = min(mult(t[j+1]), k) => 1 - sum(i in j-k..j-k+p: G[i](x)) <= r*sum(q in p+1..k: (t[j+1] - t[j+1+p-q])/(t[j+1+p] - t[j+1])); p = min(mult(t[j]), k) => 1 - sum(i in j-p..j: G[i](x)) <= 1/r*sum(q in p+1..k: (t[j-p+q] - t[j])/(t[j] - t[j-p])) *)
Definition X_limit_trace_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  forall p : nat,
  (1 <= p)%N ->
  (p <= k)%N ->
  forall x : R,
  t j <= x < t j.+1 ->
  ((p = (minn (mult t m (t j.+1))%N k))%N -> 1 - (\sum_(j - k <= i < (j + p).+1 - k) value r t m k i x) <= r * (\sum_(p.+1 <= q < k.+1) (t j.+1 - t ((j + p).+1 - q)%N) / (t ((j + p).+1)%N - t j.+1))) /\
  ((p = (minn (mult t m (t j))%N k))%N -> 1 - (\sum_(j - p <= i < j.+1) value r t m k i x) <= 1 / r * (\sum_(p.+1 <= q < k.+1) (t (j + q - p)%N - t j) / (t j - t (j - p)%N))).
Definition X_limit_trace_printed_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  forall j : nat,
  (k <= j)%N ->
  (j <= n)%N ->
  forall p : nat,
  (1 <= p)%N ->
  (p <= k)%N ->
  (j <= m)%N /\ (j <= n + k)%N /\ (forall x : R,
  t j <= x < t j.+1 ->
  ((p = (minn (mult t m (t j.+1))%N k))%N -> (forall i : nat, (j <= i + k)%N -> (k + i <= j + p)%N -> (i <= n)%N) /\ (forall q : nat, (p.+1 <= q)%N -> (q <= k)%N -> (j + p <= n + k + q)%N /\ (q <= (j + p).+1)%N /\ (j + p <= n + k)%N /\ (t ((j + p).+1)%N - t j.+1) != 0 :> R)) /\ ((p = (minn (mult t m (t j))%N k))%N -> (p <= j)%N /\ (forall i : nat, (j <= i + p)%N -> (i <= j)%N -> (i <= n)%N) /\ r != 0 :> R /\ (forall q : nat, (p.+1 <= q)%N -> (q <= k)%N -> (j + q <= (n + k + p).+1)%N /\ (p <= j + q)%N /\ (j <= (n + k + p).+1)%N /\ (t j - t (j - p)%N) != 0 :> R))).

(* X.limit.arc printed: no term of the theory says the recursion of last *)

(* X.elevation printed: no term of the theory says the word elevated *)

(* X.elevation amended: no term of the theory says the word elevated *)

(* X.condition printed: k >= 1; U clamped inner; d points; i in 0..n : some(x in [t[0], t[m]]: abs(d[i]) <= abs(C(x))) *)
Definition X_condition_printed : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Uclamped t n k ->
  Uinner t n k ->
  forall d : nat -> R,
  forall i : nat,
  (i <= n)%N ->
  (exists x : R, t 0%N <= x <= t m /\ `|d i| <= `|\sum_(0 <= i' < n.+1) d i' * value r t m k i' x|).

(* X.condition amended: k >= 1; U bernstein; x in [t[0], t[m]] : all(i in 0..n: G[i](x) = binomial(k, i)*f(x, t[0], t[m])^i*(1 - f(x, t[0], t[m]))^(k-i)); abs(sum(i in 0..n: (-1)^(k-i)*binomial(2*k, 2*i)/binomial(k, i)*G[i](x))) <= 1 *)
Definition X_condition_amended : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall x : R,
  t 0%N <= x <= t m ->
  (forall i : nat, (i <= n)%N -> value r t m k i x = ('C(k, i))%:R * (mob r x (t 0%N) (t m)) ^+ i * (1 - mob r x (t 0%N) (t m)) ^+ (k - i)%N) /\
  `|\sum_(0 <= i < n.+1) (- 1) ^+ (k - i)%N * ('C((2 * k), (2 * i)))%:R / ('C(k, i))%:R * value r t m k i x| <= 1.
Definition X_condition_amended_defined : Prop :=
  forall r : R,
  0 < r ->
  forall k : nat,
  (1 <= k)%N ->
  forall (n m : nat) (t : nat -> R),
  m = (n + k.+1)%N ->
  knots t m ->
  Ubernstein t n k ->
  forall x : R,
  t 0%N <= x <= t m ->
  (forall i : nat, (i <= n)%N -> r * (x - (t 0%N)) + ((t m) - x) != 0 /\ (i <= k)%N) /\ (forall i : nat, (i <= n)%N -> (i <= k)%N /\ ('C(k, i))%:R != 0 :> R).

(* X.weights printed: no term of the theory says the word free_weights *)
End Stanzas.
