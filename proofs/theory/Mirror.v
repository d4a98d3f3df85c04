(* The mirror image.  (1) Turning all signs: C_(-y) = 1 - C_y, D unchanged, D' changes sign, ...
   (2) Theorem A for a new knot on either side: the sign of y_t0 is the sign of the result. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower CoreInequality ListRace.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.
Local Arguments Tower.D : simpl never.

Section Mirror.
Variable R : realFieldType.
Notation pos := (all (>%R^~ (0 : R))).
Lemma cl_mirror (A B : seq R) : pos A -> pos B -> (0 < size A + size B)%N -> cl B A = 1 - cl A B.
Proof.
elim: A B => [|a A IHA] B hA hB; first by case: B hB => [//|b B] _ _; rewrite cl0 subr0.
elim: B hB => [|b B IHB] hB _; first by rewrite cl0 clA0 subrr.
have /andP[a0 hA'] := hA; have /andP[b0 hB'] := hB.
rewrite !clE (IHA (b :: B)) // ?IHB //= ?addnS //.
have d : a + b != 0 by rewrite gt_eqF // addr_gt0.
by move: (cl A (b :: B)) (cl (a :: A) B) => X Y; rewrite [b + a]addrC; field.
Qed.

Variable I : eqType.
Variable y : I -> R.
Hypothesis y_side : forall l, lft y l || rgt y l.
Notation ym := (fun l => - y l).
Lemma ym_side l : lft ym l || rgt ym l.
Proof. by rewrite orbC /lft /rgt oppr_gt0 oppr_lt0; apply: y_side. Qed.

(* all signed distances negative: C becomes 1 - C *)
Theorem C_mirror s : (0 < size s)%N -> ListRace.C ym s = 1 - ListRace.C y s.
Proof.
move=> z; have eL : Ls ym s = Rs y s.
  rewrite /Ls /Rs; have -> : [seq l <- s | lft ym l] = [seq l <- s | rgt y l].
    by apply: eq_filter => l; rewrite /lft /rgt oppr_lt0.
  by apply: eq_map => l; rewrite opprK.
have eR : Rs ym s = Ls y s.
  rewrite /Ls /Rs; have -> : [seq l <- s | rgt ym l] = [seq l <- s | lft y l].
    by apply: eq_filter => l; rewrite /lft /rgt oppr_gt0.
  by [].
rewrite /ListRace.C eL eR; apply: cl_mirror; rewrite ?Lpos ?Rpos //.
by case: s z {eL eR} => [//|l s] _; case/orP: (y_side l) => h; rewrite ?(Ls_l _ h) ?(Rs_r _ h) ?addnS.
Qed.


(* and D_(j+1) gets the sign (-1)^j *)
Theorem D_mirror j s : (j.+1 < size s)%N ->
  Tower.D ym (ListRace.C ym) j.+1 s = (-1) ^+ j * Tower.D y (ListRace.C y) j.+1 s.
Proof.
have yn l : y l != 0 := yn0 y_side l.
elim: j s => [|j IH] [|l s] // js; have yl := yn l; rewrite /= ltnS in js.
  rewrite !DE // expr0 mul1r.
  have -> : Tower.D ym (ListRace.C ym) 0 s = 1 - Tower.D y (ListRace.C y) 0 s by apply: C_mirror.
  have -> : Tower.D ym (ListRace.C ym) 0 (l :: s) = 1 - Tower.D y (ListRace.C y) 0 (l :: s) by apply: C_mirror.
  by move: (Tower.D _ _ _ s) (Tower.D _ _ _ (l :: s)) yl => X Y yl; field.
rewrite !(DE _ _ (j:=j.+1)) ?(leq_trans _ js) // !IH ?(leqW js) //.
move: (Tower.D _ _ _ s) (Tower.D _ _ _ (l :: s)) ((-1) ^+ j) yl (exprS (-1 : R) j) => X Y e yl ->.
by field.
Qed.
End Mirror.

Section Signed.
Variable R : realFieldType.
Variable I : eqType.
Variable y : I -> R.
Hypothesis y_side : forall l, lft y l || rgt y l.
Notation DD := (Tower.D y (ListRace.C y)).
Variables (V : seq I) (t0 : I) (c : I -> R).
Hypothesis uV : uniq V.
Hypothesis tV : two y V.
Hypothesis c0 : forall l, 0 <= c l.
Definition A0 := \sum_(q <- V) c q * DD 1 (q :: V).
Definition A0' := \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * DD 2 (l :: m :: V).
Definition A1 := \sum_(q <- V) c q * DD 1 (q :: t0 :: V).
Definition A1' := \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * DD 2 (l :: m :: t0 :: V).

Lemma signed_eq : y t0 * (A0 * A1' - A0' * A1) =
  y t0 ^+ 2 * (phi1 DD V t0 c 2 * phi2 DD V t0 c 2 - phi1 DD V t0 c 1 * phi2 DD V t0 c 3).
Proof.
have tw := DDtower y_side; have pm := DDperm y_side.
have zV : (2 <= size V)%N := sizeV tV.
have P (l : I) j : (j <= 2)%N -> DD j (l :: V) = DD j (l :: t0 :: V) + y t0 * DD j.+1 (l :: t0 :: V).
  move=> j2; have p i : DD i (l :: t0 :: V) = DD i (t0 :: l :: V).
    by apply: pm; rewrite (perm_catCA [:: l] [:: t0]).
  by rewrite !p; apply: tw; rewrite /= ltnS (leq_trans j2).
have Q (l m : I) j : (j <= 2)%N -> DD j (l :: m :: V) = DD j (l :: m :: t0 :: V) + y t0 * DD j.+1 (l :: m :: t0 :: V).
  move=> j2; have p i : DD i (l :: m :: t0 :: V) = DD i (t0 :: l :: m :: V).
    by apply: pm; rewrite (perm_catCA [:: l; m] [:: t0]).
  by rewrite !p; apply: tw; rewrite /= ltnS (leq_trans j2) // (leq_trans zV).
pose p1 := phi1 DD V t0 c; pose p2 := phi2 DD V t0 c.
have e0 : A0 = p1 1%N + y t0 * p1 2%N.
  rewrite /A0 /p1 /phi1 mulr_sumr -big_split /=; apply: eq_bigr => q _; rewrite P //; ring.
have e0' : A0' = p2 2%N + y t0 * p2 3%N.
  rewrite /A0' /p2 /phi2 mulr_sumr -big_split /=; apply: eq_bigr => l _.
  rewrite mulr_sumr -big_split /=; apply: eq_bigr => m _; rewrite Q //; ring.
rewrite e0 e0' -[A1]/(p1 1%N) -[A1']/(p2 2%N) -/p1 -/p2; ring.
Qed.

(* Theorem A at a point, a new knot on either side *)
Theorem theoremA_signed : 0 <= y t0 * (A0 * A1' - A0' * A1).
Proof.
have tw := DDtower y_side; have pm := DDperm y_side.
have core := core_inequality y_side (D:=DD) pm tw (DDpos y_side) (DDone y_side) t0 uV tV c0.
by rewrite signed_eq mulr_ge0 ?sqr_ge0.
Qed.

(* strict as soon as some knot of V on the other side of x than t0 has c > 0 *)
Theorem theoremA_signed_strict l : l \in V -> 0 < c l -> rgt y l != rgt y t0 -> 0 < y t0 * (A0 * A1' - A0' * A1).
Proof.
move=> lV cl sl; have tw := DDtower y_side; have pm := DDperm y_side.
have core := core_strict y_side (D:=DD) pm tw (DDpos y_side) (DDone y_side) (t0:=t0) uV tV c0 lV cl.
have y2 : 0 < y t0 ^+ 2 by rewrite exprn_even_gt0 //= (yn0 y_side).
rewrite signed_eq pmulr_rgt0 //; have /andP[hL hR] := tV; rewrite has_count in hL; rewrite has_count in hR.
have s0 := y_side t0; have s1 := y_side l.
case h0 : (rgt y t0) sl => sl; apply: core => /=.
- have -> : lft y l by move: s1 sl; case: (rgt y l); rewrite ?orbF.
  by rewrite !add1n !ltnS.
- rewrite h0; case: (rgt y l); by rewrite ?add0n ?add1n ?ltnS.
- have -> : lft y t0 by move: s0; rewrite h0 orbF.
  case: (lft y l); by rewrite ?add0n ?add1n ?ltnS.
- have -> : rgt y l by move: sl; case: (rgt y l).
  by rewrite !add1n !ltnS.
Qed.

(* a new knot on the right *)
Corollary theoremA_right : 0 < y t0 -> 0 <= A0 * A1' - A0' * A1.
Proof. by move=> h; rewrite -(pmulr_rge0 _ h) theoremA_signed. Qed.
(* a new knot on the left *)
Corollary theoremA_left : y t0 < 0 -> A0 * A1' - A0' * A1 <= 0.
Proof. by move=> h; rewrite -(nmulr_rge0 _ h) theoremA_signed. Qed.
End Signed.
