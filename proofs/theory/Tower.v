(* Lemmas 3 and 4 of theory.md: the function C of recursion (1) has the same-side relation, and the tower (2) exists. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Lists.
Variable R : realFieldType.
(* A: left lengths, B: right lengths (positive) *)
Fixpoint cl (A : seq R) : seq R -> R :=
  match A with
  | [::] => fun _ => 0
  | a :: A' => fix cla (B : seq R) : R :=
      match B with [::] => 1 | b :: B' => (a * cla B' + b * cl A' (b :: B')) / (a + b) end
  end.
Lemma cl0 B : cl [::] B = 0. Proof. by []. Qed.
Lemma clA0 a A : cl (a :: A) [::] = 1. Proof. by []. Qed.
Lemma clE a A b B : cl (a :: A) (b :: B) = (a * cl (a :: A) B + b * cl A (b :: B)) / (a + b). Proof. by []. Qed.

Lemma leftrel B p q A : all (>%R^~ 0) B -> 0 < p -> 0 < q ->
  (p - q) * cl (p :: q :: A) B = p * cl (p :: A) B - q * cl (q :: A) B.
Proof.
move=> hB p0 q0; elim: B hB => [|b B IH] /=; first by rewrite !mulr1.
case/andP=> b0 hB; have {IH} := IH hB; rewrite -/(cl (p :: q :: A) B) -/(cl (p :: A) B) -/(cl (q :: A) B).
move: (cl (p :: q :: A) B) (cl (p :: A) B) (cl (q :: A) B) (cl A (b :: B)) => Z P Q X e.
have pb : p + b != 0 by rewrite gt_eqF // addr_gt0.
have qb : q + b != 0 by rewrite gt_eqF // addr_gt0.
have pn : p != 0 by rewrite gt_eqF.
have -> : P = ((p - q) * Z + q * Q) / p by rewrite e subrK mulrC mulKf.
by field; rewrite pb qb pn.
Qed.

Lemma rightrel A p q B : all (>%R^~ 0) A -> 0 < p -> 0 < q ->
  (q - p) * cl A (p :: q :: B) = q * cl A (q :: B) - p * cl A (p :: B).
Proof.
move=> hA p0 q0; elim: A hA => [|a A IH]; first by rewrite !cl0 !mulr0 subrr.
case/andP=> a0 hA; have {IH} := IH hA; rewrite !clE.
move: (cl (a :: A) B) (cl A (p :: q :: B)) (cl A (q :: B)) (cl A (p :: B)) => X Z Q P e.
have pa : a + p != 0 by rewrite gt_eqF // addr_gt0.
have qa : a + q != 0 by rewrite gt_eqF // addr_gt0.
have pn : p != 0 by rewrite gt_eqF.
have -> : P = (q * Q - (q - p) * Z) / p by rewrite e opprB addrC subrK mulrC mulKf.
by field; rewrite pa qa pn.
Qed.
End Lists.

Section Tower.
Variable R : realFieldType.
Variable I : eqType.
Variable y : I -> R.
Hypothesis y_neq0 : forall l, y l != 0.
Variable C : seq I -> R.
Hypothesis Cperm : forall s t, perm_eq s t -> C s = C t.
Hypothesis Crel : forall s l m, (y m - y l) * C (l :: m :: s) = y m * C (m :: s) - y l * C (l :: s).

Fixpoint D (j : nat) (s : seq I) : R :=
  if j is j'.+1 then
    if (size s <= j)%N then 0 else if s is l :: s' then (D j' s' - D j' s) / y l else 0
  else C s.

Lemma DE j l s : (j < size s)%N -> D j.+1 (l :: s) = (D j s - D j (l :: s)) / y l.
Proof. by move=> h /=; rewrite ltnS leqNgt h. Qed.

(* the relation (2) of one level and the next *)
Theorem tower j s l : (j < size s)%N -> D j s = D j (l :: s) + y l * D j.+1 (l :: s).
Proof. by move=> h; rewrite DE // mulrC divfK // addrC subrK. Qed.

(* every level satisfies the relation and does not depend on the order of the knots *)
Theorem Drel_perm j :
  (forall s l m, (j <= size s)%N -> (y m - y l) * D j (l :: m :: s) = y m * D j (m :: s) - y l * D j (l :: s))
  /\ (forall s t, perm_eq s t -> D j s = D j t).
Proof.
elim: j => [|j [IHr IHp]]; first by split=> [s l m _|s t]; [exact: Crel | exact: Cperm].
split=> [s l m js|s t p].
  have yl := y_neq0 l; have ym := y_neq0 m.
  rewrite !DE ?(leq_trans js) //= ?(leqW js) //.
  have := IHr s l m (ltnW js).
  move: (D j (l :: m :: s)) (D j (m :: s)) (D j (l :: s)) (D j s) => X M L Z e.
  have -> : (y m - y l) * ((M - X) / y l) = ((y m - y l) * M - (y m - y l) * X) / y l by field.
  by rewrite e; field; rewrite yl ym.
have zz := perm_size p.
case: (leqP (size s) j.+1) => sj.
  by case: s t p zz sj => [|l s] [|m t] //= p zz sj; rewrite sj -zz sj.
case: s t p zz sj => [|l s] [|m t] //= p [zz] sj.
rewrite -zz leqNgt sj /=.
case: (eqVneq l m) p => [<-|lm] p.
  by rewrite (IHp _ _ p); move: p; rewrite perm_cons => /IHp ->.
have ms : m \in s by have := mem_head m t; rewrite -(perm_mem p) inE eq_sym (negbTE lm).
pose r := rem m s.
have ps : perm_eq s (m :: r) := perm_to_rem ms.
have pt : perm_eq t (l :: r).
  rewrite -(perm_cons m) perm_sym (perm_trans _ p) //.
  by rewrite (perm_trans (_ : perm_eq _ (l :: m :: r))) ?(perm_catCA [:: m] [:: l]) // perm_cons perm_sym.
have zr : (j <= size r)%N by move: sj; rewrite (perm_size ps) /= ltnS.
rewrite -(IHp _ _ p) (IHp _ _ ps) (IHp _ _ pt).
have -> : D j (l :: s) = D j (l :: m :: r) by apply: IHp; rewrite perm_cons.
have := IHr r l m zr; have yl := y_neq0 l; have ym := y_neq0 m.
move: (D j (l :: m :: r)) (D j (m :: r)) (D j (l :: r)) => X M L e.
have -> : L = (y m * M - (y m - y l) * X) / y l by rewrite e opprB addrC subrK mulrC mulKf.
by field; rewrite yl ym.
Qed.
End Tower.
