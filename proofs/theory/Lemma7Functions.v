(* Lemma 7 on every level of the tower, and as a statement about functions of x.
   part 1 (algebra, one point): dD = D differentiated by the rules equals sum c_l D_(V+l) one level up (y_l' = - c_l).
   part 2 (functions of x on an open interval): the x-derivative of D j V is sum_l c_l D (j+1) (V+l). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower CoreInequality ListRace Lemma7 RationalDerivative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Local Arguments Tower.D : simpl never.

Section Level.
Variable R : realFieldType.
Variable I : eqType.
Variables y c : I -> R.
Hypothesis y_side : forall l, lft y l || rgt y l.
Notation DD := (Tower.D y (ListRace.C y)).
Definition sumDD j s := \sum_(l <- s) c l * DD j.+1 (l :: s).

Lemma sumDD_perm j s t : perm_eq s t -> sumDD j s = sumDD j t.
Proof.
move=> p; rewrite /sumDD (perm_big _ p); apply: eq_bigr => l _.
by congr (_ * _); apply: (DDperm y_side); rewrite perm_cons.
Qed.

(* the quotient rule for D (j+1) (l :: s) = (D j s - D j (l :: s)) / y_l, with the derivatives of D j given by sumDD j *)
Lemma level_up j l s : (j < size s)%N ->
  ((sumDD j s - sumDD j (l :: s)) * y l - (DD j s - DD j (l :: s)) * - c l) / y l ^+ 2 = sumDD j.+1 (l :: s).
Proof.
move=> js; have yl := yn0 y_side l.
have t0 : DD j s = DD j (l :: s) + y l * DD j.+1 (l :: s) by apply: (DDtower y_side).
have t1 m : DD j.+1 (m :: s) = DD j.+1 (m :: l :: s) + y l * DD j.+2 (m :: l :: s).
  have p i : DD i (m :: l :: s) = DD i (l :: m :: s).
    by apply: (DDperm y_side); rewrite (perm_catCA [:: m] [:: l]).
  by rewrite !p; apply: (DDtower y_side).
have tl : DD j.+1 (l :: s) = DD j.+1 (l :: l :: s) + y l * DD j.+2 (l :: l :: s) by exact: t1.
have S : sumDD j s = \sum_(m <- s) c m * DD j.+1 (m :: l :: s) + y l * \sum_(m <- s) c m * DD j.+2 (m :: l :: s).
  rewrite /sumDD mulr_sumr -big_split /=; apply: eq_bigr => m _; rewrite t1; ring.
rewrite S /sumDD !big_cons t0 tl.
move: (DD j (l :: s)) (DD j.+1 (l :: l :: s)) (DD j.+2 (l :: l :: s)) (\sum_(m <- s) c m * DD j.+1 (m :: l :: s))
  (\sum_(m <- s) c m * DD j.+2 (m :: l :: s)) yl => x1 x2 x3 x4 x5 yl.
by field.
Qed.
End Level.

Section Functions.
Variable R : realFieldType.
Variables u v : R.
Variable I : eqType.
Variables y c : R -> I -> R.      (* y x l = y_l(x),  c x l = - y_l'(x) *)
Variable sd : I -> bool.          (* true: right *)
Hypothesis y_sd : forall x l, u < x < v -> if sd l then 0 < y x l else y x l < 0.
Hypothesis y_der : forall l, isd u v (fun x => y x l) (fun x => - c x l).
Notation DDx x := (Tower.D (y x) (ListRace.C (y x))).

Lemma y_side x : u < x < v -> forall l, lft (y x) l || rgt (y x) l.
Proof. by move=> hx l; have := y_sd l hx; rewrite /lft /rgt; case: (sd l) => ->; rewrite ?orbT. Qed.
Lemma rgtE x l : u < x < v -> rgt (y x) l = sd l.
Proof.
by move=> hx; have := y_sd l hx; case: (sd l) => // h; apply: negbTE; rewrite /rgt -leNgt ltW.
Qed.
Lemma lftE x l : u < x < v -> lft (y x) l = ~~ sd l.
Proof.
by move=> hx; have := y_sd l hx; case: (sd l) => // h; apply: negbTE; rewrite /lft -leNgt ltW.
Qed.

Lemma allL x A : u < x < v -> all (fun l => ~~ sd l) A -> all (lft (y x)) A.
Proof. by move=> hx /allP h; apply/allP => l /h; rewrite lftE. Qed.
Lemma allR x B : u < x < v -> all sd B -> all (rgt (y x)) B.
Proof. by move=> hx /allP h; apply/allP => l /h; rewrite rgtE. Qed.

Lemma C_cat x A B : u < x < v -> all (fun l => ~~ sd l) A -> all sd B ->
  ListRace.C (y x) (A ++ B) = cl [seq - y x l | l <- A] [seq y x l | l <- B].
Proof.
move=> hx hA hB; rewrite /ListRace.C /Ls /Rs !filter_cat.
have -> : [seq l <- A | lft (y x) l] = A by apply/all_filterP/allL.
have -> : [seq l <- B | rgt (y x) l] = B by apply/all_filterP/allR.
have -> : [seq l <- B | lft (y x) l] = [::].
  by apply/eqP; rewrite -[_ == _]negbK -has_filter; apply/hasPn => l /(allP hB); rewrite lftE // => ->.
have -> : [seq l <- A | rgt (y x) l] = [::].
  by apply/eqP; rewrite -[_ == _]negbK -has_filter; apply/hasPn => l /(allP hA); rewrite rgtE.
by rewrite cats0.
Qed.

(* the recursion, differentiated step by step *)
Lemma isd_dcl A B : all (fun l => ~~ sd l) A -> all sd B ->
  isd u v (fun x => ListRace.C (y x) (A ++ B)) (fun x => dcl (y x) (c x) A B).
Proof.
elim: A B => [|a A IHA] B hA hB.
  apply: (isd_ext (isd_const u v 0)) => x hx //; by rewrite C_cat.
elim: B hB => [|b B IHB] hB.
  apply: (isd_ext (isd_const u v 1)) => x hx //; by rewrite C_cat.
have /andP[ha hA'] := hA; have /andP[hb hB'] := hB.
have d x : u < x < v -> - y x a + y x b != 0.
  move=> hx; have := y_sd a hx; have := y_sd b hx; rewrite hb (negbTE ha) => h1 h2.
  by rewrite gt_eqF // addr_gt0 // oppr_gt0.
have Ya := isd_opp (y_der a); have Yb := y_der b.
have N := isd_add (isd_mul Ya (IHB hB')) (isd_mul Yb (IHA (b :: B) hA' hB)).
apply: (isd_ext (isd_div N (isd_add Ya Yb) d)) => x hx.
  by rewrite !C_cat //.
rewrite dclE; have := d x hx.
have -> : ListRace.C (y x) (a :: A ++ b :: B) = (- y x a * ListRace.C (y x) (a :: A ++ B) + y x b * ListRace.C (y x) (A ++ b :: B)) / (- y x a + y x b).
  by rewrite -!cat_cons !C_cat.
rewrite -!cat_cons.
move: (ListRace.C (y x) ((a :: A) ++ B)) (ListRace.C (y x) (A ++ b :: B)) (dcl (y x) (c x) (a :: A) B) (dcl (y x) (c x) A (b :: B)).
by move: (y x a) (y x b) (c x a) (c x b) => ya yb ca cb z1 z2 z3 z4 dn; field.
Qed.

Lemma side_split s : perm_eq s ([seq l <- s | ~~ sd l] ++ [seq l <- s | sd l]).
Proof. by rewrite perm_sym perm_catC; apply/permPl; apply: (perm_filterC sd s). Qed.

(* Lemma 7, every level *)
Theorem lemma7_fun j s : (j < size s)%N ->
  isd u v (fun x => DDx x j s) (fun x => \sum_(l <- s) c x l * DDx x j.+1 (l :: s)).
Proof.
elim: j s => [|j IH] s js.
  have p := side_split s.
  have hA : all (fun l => ~~ sd l) [seq l <- s | ~~ sd l] by apply: filter_all.
  have hB : all sd [seq l <- s | sd l] by apply: filter_all.
  apply: (isd_ext (isd_dcl hA hB)) => x hx.
    by apply: (Cperm (y x)).
  rewrite (@lemma7 _ _ (y x) (c x) (y_side hx)) ?allL ?allR //; last by rewrite -(perm_size p).
  exact: (@sumDD_perm _ _ (y x) (c x) (y_side hx) 0 _ _ p).
case: s js => [//|l s] js; rewrite /= ltnS in js.
have n x : u < x < v -> y x l != 0 by move=> hx; apply: (yn0 (y_side hx)).
have h1 := IH s js; have h2 := IH (l :: s) (ltnW js).
apply: (isd_ext (isd_div (isd_sub h1 h2) (y_der l) n)) => x hx.
  by rewrite DE.
exact: esym (@level_up _ _ (y x) (c x) (y_side hx) j l s js).
Qed.
End Functions.
