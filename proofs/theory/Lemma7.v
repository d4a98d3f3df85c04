(* Lemma 7: the recursion (1) differentiated by the quotient rule (y_l' = - c_l) gives C' = sum c_l D_(V+l). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower CoreInequality ListRace.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Lemma7.
Variable R : realFieldType.
Variable I : eqType.
Variables y c : I -> R.
Hypothesis y_side : forall l, lft y l || rgt y l.
Notation C := (ListRace.C y).
Notation DD := (Tower.D y C).

Fixpoint dcl (A : seq I) : seq I -> R :=
  match A with
  | [::] => fun _ => 0
  | a :: A' => fix dcla (B : seq I) : R :=
      match B with
      | [::] => 0
      | b :: B' => (c a * (C (a :: A' ++ B') - C (a :: A' ++ b :: B'))
                    - c b * (C (A' ++ b :: B') - C (a :: A' ++ b :: B'))
                    + - y a * dcla B' + y b * dcl A' (b :: B')) / (- y a + y b)
      end
  end.
Lemma dclE a A b B : dcl (a :: A) (b :: B) =
  (c a * (C (a :: A ++ B) - C (a :: A ++ b :: B)) - c b * (C (A ++ b :: B) - C (a :: A ++ b :: B))
   + - y a * dcl (a :: A) B + y b * dcl A (b :: B)) / (- y a + y b).
Proof. by []. Qed.

Let sumD s := \sum_(l <- s) c l * DD 1 (l :: s).
Lemma sumD_perm s t : perm_eq s t -> sumD s = sumD t.
Proof.
move=> p; rewrite /sumD (perm_big _ p); apply: eq_bigr => l _.
by congr (_ * _); apply: (DDperm y_side); rewrite perm_cons.
Qed.

Lemma sumD_one s : (1 <= size s)%N -> ~~ has (lft y) s \/ ~~ has (rgt y) s -> sumD s = 0.
Proof.
move=> z h; rewrite /sumD big_seq big1 // => l ls; rewrite (DDone y_side) ?mulr0 //.
rewrite /two negb_and; case: h => h; apply/orP; [left|right]; apply/hasPn => x;
  by rewrite inE => /orP[/eqP ->|xs]; apply: (hasPn h).
Qed.

(* the recursion differentiated by the quotient rule is the sum of c_l D_(V+l) *)
Theorem lemma7 A B : all (lft y) A -> all (rgt y) B -> (1 <= size (A ++ B))%N -> dcl A B = sumD (A ++ B).
Proof.
elim: A B => [|a A IHA] B hA hB z.
  rewrite sumD_one //; left; apply/hasPn => x xB; by rewrite (rgt_lftF (allP hB x xB)).
have /andP[ha hA'] := hA.
elim: B hB z => [|b B IHB] hB z.
  rewrite cats0 sumD_one //; right; apply/hasPn => x xA; by rewrite (lft_rgtF (allP hA x xA)).
have /andP[hb hB'] := hB.
rewrite dclE IHB // IHA //; last by rewrite size_cat /= addnS.
pose s2 := A ++ B.
have p1 : perm_eq (A ++ b :: B) (b :: s2) by rewrite (perm_catCA A [:: b] B).
have p2 : perm_eq ((a :: A) ++ b :: B) (a :: b :: s2) by rewrite /= perm_cons.
have p3 : perm_eq (a :: b :: s2) (b :: a :: s2) by rewrite (perm_catCA [:: a] [:: b]).
rewrite (sumD_perm p1) (sumD_perm p2) -/s2.
have -> : C (a :: A ++ b :: B) = C (a :: b :: s2) by apply: Cperm; rewrite perm_cons.
have -> : C (A ++ b :: B) = C (b :: s2) by apply: Cperm.
have e1 : C (b :: s2) = C (a :: b :: s2) + y a * DD 1 (a :: b :: s2) by apply: (DDtower y_side (j:=0)).
have e2 : C (a :: s2) = C (a :: b :: s2) + y b * DD 1 (a :: b :: s2).
  by rewrite (Cperm y p3) (DDperm y_side 1 p3); apply: (DDtower y_side (j:=0)).
rewrite e1 e2 /sumD !big_cons.
have rel l s : (1 <= size s)%N -> (y b - y a) * DD 1 (l :: a :: b :: s) = y b * DD 1 (l :: b :: s) - y a * DD 1 (l :: a :: s).
  move=> zs.
  have -> : DD 1 (l :: a :: b :: s) = DD 1 (a :: b :: l :: s).
    by apply: (DDperm y_side); rewrite (perm_catCA [:: l] [:: a; b]).
  have -> : DD 1 (l :: b :: s) = DD 1 (b :: l :: s) by apply: (DDperm y_side); rewrite (perm_catCA [:: l] [:: b]).
  have -> : DD 1 (l :: a :: s) = DD 1 (a :: l :: s) by apply: (DDperm y_side); rewrite (perm_catCA [:: l] [:: a]).
  exact: (DDrel y_side).
have relg l : (y b - y a) * DD 1 (l :: a :: b :: s2) = y b * DD 1 (l :: b :: s2) - y a * DD 1 (l :: a :: s2).
  have -> : DD 1 (l :: a :: b :: s2) = DD 1 (a :: b :: l :: s2).
    by apply: (DDperm y_side); rewrite (perm_catCA [:: l] [:: a; b]).
  have -> : DD 1 (l :: b :: s2) = DD 1 (b :: l :: s2) by apply: (DDperm y_side); rewrite (perm_catCA [:: l] [:: b]).
  have -> : DD 1 (l :: a :: s2) = DD 1 (a :: l :: s2) by apply: (DDperm y_side); rewrite (perm_catCA [:: l] [:: a]).
  exact: (DDrel y_side).
have d : 0 < y b - y a by rewrite subr_gt0 (lt_trans ha hb).
have dn : y b - y a != 0 by rewrite gt_eqF.
have dn' : - y a + y b != 0 by rewrite addrC.
apply: (mulfI dn').
rewrite [LHS]mulrC divfK // [- y a + y b]addrC !mulrDr.
have S : (y b - y a) * (\sum_(l <- s2) c l * DD 1 (l :: a :: b :: s2)) =
   y b * (\sum_(l <- s2) c l * DD 1 (l :: b :: s2)) - y a * (\sum_(l <- s2) c l * DD 1 (l :: a :: s2)).
  rewrite !mulr_sumr -sumrB; apply: eq_bigr => l _.
  have -> : (y b - y a) * (c l * DD 1 (l :: a :: b :: s2)) = c l * ((y b - y a) * DD 1 (l :: a :: b :: s2)) by ring.
  by rewrite relg; ring.
have Ea : (y b - y a) * (c a * DD 1 (a :: a :: b :: s2)) = c a * (y b * DD 1 (a :: b :: s2) - y a * DD 1 (a :: a :: s2)).
  by rewrite -relg; ring.
have q : DD 1 (b :: a :: s2) = DD 1 (a :: b :: s2) by apply: (DDperm y_side); rewrite perm_sym.
have Eb : (y b - y a) * (c b * DD 1 (b :: a :: b :: s2)) = c b * (y b * DD 1 (b :: b :: s2) - y a * DD 1 (a :: b :: s2)).
  by rewrite -q -relg; ring.
rewrite Ea Eb S.
move: (DD 1 (a :: b :: s2)) (DD 1 (a :: a :: s2)) (DD 1 (b :: b :: s2)) (C (a :: b :: s2))
  (\sum_(l <- s2) c l * DD 1 (l :: b :: s2)) (\sum_(l <- s2) c l * DD 1 (l :: a :: s2)) => x1 x2 x3 x4 x5 x6.
ring.
Qed.
End Lemma7.
