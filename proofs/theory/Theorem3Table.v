(* The bridge to Race.v and Theorem 3.
   On the open span (u,v): left knots tL 0 >= tL 1 >= ... (<= u), right knots tR 0 <= tR 1 <= ... (>= v), r > 0.
   G_i^k = G n m, n = s - i, m = k - n (Race.v);  C_i^k = C (n+1) m,  A_i = C_i' ;  G_i' = A (n+1) m - A n (m+1).
   The table is computed with triples (value, first, second derivative). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Race Tower CoreInequality ListRace Lemma7 RationalDerivative Lemma7Functions Mirror Gauge TheoremA.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.
Local Arguments Tower.D : simpl never.

Section Table.
Variable R : realFieldType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variables u v : R.
Variables tL tR : nat -> R.
Hypothesis tLu : forall n, tL n <= u.
Hypothesis tRv : forall m, v <= tR m.
Hypothesis tL_mono : forall n, tL n.+1 <= tL n.
Hypothesis tR_mono : forall m, tR m <= tR m.+1.
Definition a x n := x - tL n.
Definition b x m := tR m - x.
Lemma a0 x : u < x < v -> forall n, 0 < a x n.
Proof. by case/andP=> h _ n; rewrite subr_gt0 (le_lt_trans (tLu n)). Qed.
Lemma b0 x : u < x < v -> forall m, 0 < b x m.
Proof. by case/andP=> _ h m; rewrite subr_gt0 (lt_le_trans h). Qed.

(* triples: value, first, second derivative; the recursion of C and of G (Leibniz rule) *)
Definition triple := (R * R * R)%type.
Definition tadd (f g : triple) : triple := (f.1.1 + g.1.1, f.1.2 + g.1.2, f.2 + g.2).
Definition tmul (f g : triple) : triple :=
  (f.1.1 * g.1.1, f.1.2 * g.1.1 + f.1.1 * g.1.2, f.2 * g.1.1 + 2%:R * (f.1.2 * g.1.2) + f.1.1 * g.2).
(* w = r a/(r a + b), w' = r (a+b)/(r a + b)^2, w'' = -2 r (r-1) (a+b)/(r a + b)^3,  v = 1 - w *)
Definition tw x n m : triple :=
  (r * a x n / den r (a x) (b x) n m, r * (a x n + b x m) / den r (a x) (b x) n m ^+ 2,
   - (2%:R * r * (r - 1) * (a x n + b x m) / den r (a x) (b x) n m ^+ 3)).
Definition tv x n m : triple :=
  (b x m / den r (a x) (b x) n m, - (r * (a x n + b x m) / den r (a x) (b x) n m ^+ 2),
   2%:R * r * (r - 1) * (a x n + b x m) / den r (a x) (b x) n m ^+ 3).
Definition one3 : triple := (1, 0, 0). Definition zero3 : triple := (0, 0, 0).
Section At.
Variable x : R.
Fixpoint C3 (n : nat) : nat -> triple :=
  match n with
  | 0 => fun m => if m is 0 then one3 else zero3
  | n'.+1 => fix Cn (m : nat) : triple :=
      if m is m'.+1 then tadd (tmul (tw x n' m') (Cn m')) (tmul (tv x n' m') (C3 n' m'.+1)) else one3
  end.
Lemma C3SS n m : C3 n.+1 m.+1 = tadd (tmul (tw x n m) (C3 n.+1 m)) (tmul (tv x n m) (C3 n m.+1)). Proof. by []. Qed.
Fixpoint G3 (n : nat) : nat -> triple :=
  match n with
  | 0 => fix G0 (m : nat) : triple := match m with 0 => one3 | m'.+1 => tmul (tw x 0 m') (G0 m') end
  | n'.+1 => fix Gn (m : nat) : triple :=
      match m with
      | 0 => tmul (tv x n' 0) (G3 n' 0)
      | m'.+1 => tadd (tmul (tw x n'.+1 m') (Gn m')) (tmul (tv x n' m'.+1) (G3 n' m'.+1))
      end
  end.

Lemma G3SS n m : G3 n.+1 m.+1 = tadd (tmul (tw x n.+1 m) (G3 n.+1 m)) (tmul (tv x n m.+1) (G3 n m.+1)). Proof. by []. Qed.

(* the first two components are Race.v's dual numbers *)
Lemma C3_dual n m : (C3 n m).1 = Race.C r (a x) (b x) n m.
Proof.
elim: n m => [|n IHn] m; first by case: m.
by elim: m => [|m IHm] //; rewrite C3SS CSS -IHm -IHn.
Qed.
Lemma G3_dual n m : (G3 n m).1 = Race.G r (a x) (b x) n m.
Proof.
elim: n m => [|n IHn] m; first by elim: m => [|m IHm] //; rewrite G0S /F -IHm.
elim: m => [|m IHm]; first by rewrite GS0 /H -IHn.
by rewrite G3SS GSS /F /H -IHm -IHn.
Qed.
End At.
Definition A x n m := (C3 x n m).1.2.
Definition A' x n m := (C3 x n m).2.

(* components are derivatives of each other *)
Definition isd3 (f : R -> triple) := isd u v (fun x => (f x).1.1) (fun x => (f x).1.2) /\ isd u v (fun x => (f x).1.2) (fun x => (f x).2).
Lemma isd3_const f : isd3 (fun _ => (f, 0, 0)).
Proof. by split; apply: isd_const. Qed.
Lemma isd3_add f g : isd3 f -> isd3 g -> isd3 (fun x => tadd (f x) (g x)).
Proof. by case=> h1 h2 [h3 h4]; split; apply: isd_add. Qed.
Lemma isd3_mul f g : isd3 f -> isd3 g -> isd3 (fun x => tmul (f x) (g x)).
Proof.
case=> h1 h2 [h3 h4]; split; first exact: isd_mul.
apply: (isd_ext (isd_add (isd_mul h2 h3) (isd_mul h1 h4))) => x hx //=.
by ring.
Qed.
Lemma a_der n : isd u v (fun x => a x n) (fun _ => 1).
Proof. by apply: (isd_ext (isd_sub (isd_id u v) (isd_const u v (tL n)))) => x _ //; rewrite subr0. Qed.
Lemma b_der m : isd u v (fun x => b x m) (fun _ => -1).
Proof. by apply: (isd_ext (isd_sub (isd_const u v (tR m)) (isd_id u v))) => x _ //; rewrite sub0r. Qed.
Lemma den_der n m : isd u v (fun x => den r (a x) (b x) n m) (fun _ => r - 1).
Proof. by apply: (isd_ext (isd_add (isd_scale r (a_der n)) (b_der m))) => x _ //; rewrite mulr1. Qed.
Lemma den0 x n m : u < x < v -> den r (a x) (b x) n m != 0.
Proof. by move=> hx; apply: den_neq0 => //; [apply: a0 | apply: b0]. Qed.
Lemma den2 n m : isd u v (fun x => den r (a x) (b x) n m ^+ 2) (fun x => 2%:R * (r - 1) * den r (a x) (b x) n m).
Proof.
apply: (isd_ext (isd_mul (den_der n m) (den_der n m))) => x _; first by rewrite expr2.
by move: (den _ _ _ _ _) => d; ring.
Qed.
Lemma ab_der n m : isd u v (fun x => a x n + b x m) (fun _ => 0).
Proof. by apply: (isd_ext (isd_add (a_der n) (b_der m))) => x _ //; rewrite subrr. Qed.
Lemma w2_der n m : isd u v (fun x => r * (a x n + b x m) / den r (a x) (b x) n m ^+ 2)
  (fun x => - (2%:R * r * (r - 1) * (a x n + b x m) / den r (a x) (b x) n m ^+ 3)).
Proof.
have d2 x : u < x < v -> den r (a x) (b x) n m ^+ 2 != 0 by move=> hx; rewrite expf_neq0 // den0.
apply: (isd_ext (isd_div (isd_scale r (ab_der n m)) (den2 n m) d2)) => x hx //.
by move: (den0 n m hx); move: (den _ _ _ _ _) (a x n + b x m) => d s dn; field.
Qed.
Lemma tw_der n m : isd3 (fun x => tw x n m).
Proof.
split; last exact: w2_der.
apply: (isd_ext (isd_div (isd_scale r (a_der n)) (den_der n m) (fun x hx => den0 n m hx))) => x hx //=.
have := den0 n m hx; rewrite /den; move: (a x n) (b x m) => p q dn; by field.
Qed.
Lemma tv_der n m : isd3 (fun x => tv x n m).
Proof.
split; last by apply: (isd_ext (isd_opp (w2_der n m))) => x hx //=; rewrite opprK.
apply: (isd_ext (isd_div (b_der m) (den_der n m) (fun x hx => den0 n m hx))) => x hx //=.
have := den0 n m hx; rewrite /den; move: (a x n) (b x m) => p q dn; by field.
Qed.
(* the parts of a triple of the cumulative functions are derivatives of each other *)
Theorem C3_der n m : isd3 (fun x => C3 x n m).
Proof.
elim: n m => [|n IHn] m; first by case: m => [|m]; apply: isd3_const.
elim: m => [|m IHm]; first exact: isd3_const.
exact: (isd3_add (isd3_mul (tw_der n m) IHm) (isd3_mul (tv_der n m) (IHn m.+1))).
Qed.
(* and of the functions themselves *)
Theorem G3_der n m : isd3 (fun x => G3 x n m).
Proof.
elim: n m => [|n IHn] m.
  elim: m => [|m IHm]; first exact: isd3_const.
  exact: (isd3_mul (tw_der 0 m) IHm).
elim: m => [|m IHm]; first exact: (isd3_mul (tv_der n 0) (IHn 0%N)).
exact: (isd3_add (isd3_mul (tw_der n.+1 m) IHm) (isd3_mul (tv_der n m.+1) (IHn m.+1))).
Qed.

(* the list recursion with occurrences: (true, m) the m-th right, (false, n) the n-th left knot *)
Definition I := (bool * nat)%type.
Definition tt_ (l : I) := if l.1 then tR l.2 else tL l.2.
Definition lam (l : I) : R := if l.1 then r else 1.
Definition sd (l : I) := l.1.
Lemma lam0 l : 0 < lam l. Proof. by rewrite /lam; case: l.1; rewrite ?ltr01. Qed.
Lemma t_sd l : if sd l then v <= tt_ l else tt_ l <= u.
Proof. by case: l => [[] n]; rewrite /sd /tt_ /=. Qed.
Fixpoint LV n : seq I := if n is n'.+1 then (false, n') :: LV n' else [::].
Fixpoint RV m : seq I := if m is m'.+1 then (true, m') :: RV m' else [::].
Definition VV n m := LV n ++ RV m.
Lemma LVP n l : (l \in LV n) = ~~ l.1 && (l.2 < n)%N.
Proof.
elim: n => [|n IH]; first by rewrite in_nil ltn0 andbF.
rewrite /= inE IH ltnS [(l.2 <= n)%N]leq_eqVlt; case: l {IH} => [[] k]; rewrite /= ?xpair_eqE //=.
Qed.
Lemma RVP n l : (l \in RV n) = l.1 && (l.2 < n)%N.
Proof.
elim: n => [|n IH]; first by rewrite in_nil ltn0 andbF.
rewrite /= inE IH ltnS [(l.2 <= n)%N]leq_eqVlt; case: l {IH} => [[] k]; by rewrite /= ?xpair_eqE.
Qed.
Lemma LV_uniq n : uniq (LV n).
Proof. by elim: n => [|n IH] //=; rewrite IH LVP ltnn. Qed.
Lemma RV_uniq n : uniq (RV n).
Proof. by elim: n => [|n IH] //=; rewrite IH RVP ltnn. Qed.
Lemma VVP n m l : (l \in VV n m) = if l.1 then (l.2 < m)%N else (l.2 < n)%N.
Proof. by rewrite mem_cat LVP RVP; case: l.1; rewrite ?orbF. Qed.
Lemma VV_uniq n m : uniq (VV n m).
Proof.
rewrite cat_uniq LV_uniq RV_uniq andbT /=; apply/hasPn => l; rewrite RVP => /andP[h _].
by have := LVP n l; rewrite h => /negbT.
Qed.
Lemma LV_all n : all (fun l => ~~ sd l) (LV n).
Proof. by apply/allP => l; rewrite LVP => /andP[]. Qed.
Lemma RV_all n : all sd (RV n).
Proof. by apply/allP => l; rewrite RVP => /andP[]. Qed.
Lemma VV_size n m : size (VV n m) = (n + m)%N.
Proof.
by rewrite size_cat; congr (_ + _)%N; [elim: n => //= n -> | elim: m => //= m ->].
Qed.

Notation Cx x V := (ListRace.C (yy tt_ lam x) V).
Lemma cl_table x n m : u < x < v -> (0 < n + m)%N ->
  cl [seq - yy tt_ lam x l | l <- LV n] [seq yy tt_ lam x l | l <- RV m] = (Race.C r (a x) (b x) n m).1.
Proof.
move=> hx; elim: n m => [|n IHn] m; first by case: m => [|m].
elim: m => [|m IHm] _ //.
rewrite [LV _]/= [RV _]/= !map_cons clE CSS.
have -> : - yy tt_ lam x (false, n) = a x n by rewrite /yy /tt_ /lam /a /= divr1 opprB.
have -> : yy tt_ lam x (true, m) = b x m / r by [].
have := IHm isT; rewrite [LV _]/= map_cons.
have -> : - yy tt_ lam x (false, n) = a x n by rewrite /yy /tt_ /lam /a /= divr1 opprB.
move=> ->; have := IHn m.+1; rewrite addnS => /(_ isT); rewrite [RV _]/= map_cons.
have -> : yy tt_ lam x (true, m) = b x m / r by [].
move=> ->; rewrite /da /dm /w /Race.v /den /=.
have := den0 n m hx; rewrite /den; have := lt0r_neq0 r0.
move: (a x n) (b x m) (Race.C r (a x) (b x) n.+1 m).1 (Race.C r (a x) (b x) n m.+1).1 => p q X Y rn dn.
have d2 : p * r + q != 0 by rewrite mulrC.
by field; rewrite ?rn ?dn ?d2.
Qed.
(* the table is the recursion on lists of knots *)
Theorem C_table x n m W : u < x < v -> perm_eq W (VV n m) -> (0 < n + m)%N -> (C3 x n m).1.1 = Cx x W.
Proof.
move=> hx p z; rewrite (Cperm _ p) C3_dual -cl_table //; apply: esym.
exact: (C_cat (yy_sd lam0 t_sd) hx (LV_all n) (RV_all m)).
Qed.

Notation AAx x W := (AA tt_ lam x W). Notation AAx' x W := (AA' tt_ lam x W).
(* the first derivatives in the table are those of the lists *)
Theorem A_table x n m W : u < x < v -> perm_eq W (VV n m) -> (0 < n + m)%N -> A x n m = AAx x W.
Proof.
move=> hx p z; have [h1 _] := C3_der n m.
have zW : (0 < size W)%N by rewrite (perm_size p) VV_size.
exact: (isd_uniq h1 (AA_der lam0 t_sd zW) (fun x hx => C_table hx p z) hx).
Qed.
(* and the second ones *)
Theorem A'_table x n m W : u < x < v -> perm_eq W (VV n m) -> (0 < n + m)%N -> A' x n m = AAx' x W.
Proof.
move=> hx p z; have [_ h1] := C3_der n m.
have zW : (0 < size W)%N by rewrite (perm_size p) VV_size.
have uW : uniq W by rewrite (perm_uniq p) VV_uniq.
exact: (isd_uniq h1 (AA_der2 lam0 t_sd uW zW) (fun x hx => A_table hx p z) hx).
Qed.

Lemma tL_le n k : (n <= k)%N -> tL k <= tL n.
Proof.
move=> nk; rewrite -(subnK nk); elim: (k - n)%N => [|d IH] //.
by rewrite addSn (le_trans (tL_mono _)).
Qed.
Lemma tR_le n k : (n <= k)%N -> tR n <= tR k.
Proof.
move=> nk; rewrite -(subnK nk); elim: (k - n)%N => [|d IH] //.
by rewrite addSn (le_trans IH).
Qed.
Lemma VV_hasR n m : (0 < m)%N -> has sd (VV n m).
Proof. by move=> h; apply/hasP; exists (true, 0%N) => //; rewrite VVP. Qed.
Lemma VV_hasL n m : (0 < n)%N -> has (fun l => ~~ sd l) (VV n m).
Proof. by move=> h; apply/hasP; exists (false, 0%N) => //; rewrite VVP. Qed.

(* A = C' > 0 as soon as there is a left and a right knot *)
Theorem A_gt0 x n m : u < x < v -> (0 < n)%N -> (0 < m)%N -> 0 < A x n m.
Proof.
move=> hx n0 m0; rewrite (A_table hx (perm_refl (VV n m))) ?addn_gt0 ?n0 //.
exact: (AA_gt0 lam0 t_sd (VV_hasR n m0) (VV_hasL m n0) hx).
Qed.
Lemma A_0m x m : A x 0 m = 0. Proof. by case: m. Qed.
Lemma A_n0 x n : A x n 0 = 0. Proof. by case: n. Qed.
Lemma A'_0m x m : A' x 0 m = 0. Proof. by case: m. Qed.
Lemma A'_n0 x n : A' x n 0 = 0. Proof. by case: n. Qed.
(* no cumulative function falls *)
Theorem A_ge0 x n m : u < x < v -> 0 <= A x n m.
Proof.
move=> hx; case: n => [|n]; first by rewrite A_0m.
case: m => [|m]; first by rewrite A_n0.
by rewrite ltW // A_gt0.
Qed.

(* one more right knot: A n (m+1) / A n m increasing;  one more left knot: A (n+1) m / A n m decreasing (strictly) *)
Theorem A_right x n m : u < x < v -> (0 < n)%N -> (0 < m)%N -> 0 < A x n m * A' x n m.+1 - A' x n m * A x n m.+1.
Proof.
move=> hx n0 m0; have z : (0 < n + m)%N by rewrite addn_gt0 n0.
have p : perm_eq ((true, m) :: VV n m) (VV n m.+1).
  by rewrite perm_sym /VV /=; apply/permPl; apply: (perm_catCA (LV n) [:: (true, m)] (RV m)).
have z1 : (0 < n + m.+1)%N by rewrite addnS.
rewrite (A_table hx (perm_refl (VV n m)) z) (A'_table hx (perm_refl (VV n m)) z) (A_table hx p z1) (A'_table hx p z1).
have uU : uniq ((true, m) :: VV n m) by rewrite (perm_uniq p) VV_uniq.
apply: (theoremA_fun_right lam0 t_sd uU (VV_hasR n m0) (VV_hasL m n0)) => // -[[] k]; rewrite VVP /= /tt_ /= => h.
  by apply: tR_le; apply: ltnW.
by apply: (le_trans (tLu k)); apply: (le_trans _ (tRv m)); case/andP: hx => h1 h2; apply: ltW; apply: lt_trans h2.
Qed.
(* one more left knot: A (n+1) m / A n m falls strictly *)
Theorem A_left x n m : u < x < v -> (0 < n)%N -> (0 < m)%N -> A x n m * A' x n.+1 m - A' x n m * A x n.+1 m < 0.
Proof.
move=> hx n0 m0; have z : (0 < n + m)%N by rewrite addn_gt0 n0.
have z1 : (0 < n.+1 + m)%N by rewrite addSn.
have p : perm_eq ((false, n) :: VV n m) (VV n.+1 m) by [].
rewrite (A_table hx (perm_refl (VV n m)) z) (A'_table hx (perm_refl (VV n m)) z) (A_table hx p z1) (A'_table hx p z1).
have uU : uniq ((false, n) :: VV n m) by rewrite (perm_uniq p) VV_uniq.
apply: (theoremA_fun_left lam0 t_sd uU (VV_hasR n m0) (VV_hasL m n0)) => // -[[] k]; rewrite VVP /= /tt_ /= => h.
  by apply: (le_trans (tLu n)); apply: (le_trans _ (tRv k)); case/andP: hx => h1 h2; apply: ltW; apply: lt_trans h2.
by apply: tL_le; apply: ltnW.
Qed.

(* The corollary: A_i A_(i+1)' - A_i' A_(i+1) > 0 at every point of the open span where both A are not identically 0
   (n, m >= 1), every degree n + m; >= 0 always *)
Theorem A_ratio_strict x n m : u < x < v -> (0 < n)%N -> (0 < m)%N ->
  0 < A x n.+1 m * A' x n m.+1 - A' x n.+1 m * A x n m.+1.
Proof.
move=> hx n0 m0; have g0 : 0 < A x n m by apply: A_gt0.
have h1 := A_left hx n0 m0; have h2 := A_right hx n0 m0.
have f0 : 0 < A x n.+1 m by apply: A_gt0. have k0 : 0 < A x n m.+1 by apply: A_gt0.
rewrite -(pmulr_rgt0 _ g0).
have -> : A x n m * (A x n.+1 m * A' x n m.+1 - A' x n.+1 m * A x n m.+1) =
   A x n.+1 m * (A x n m * A' x n m.+1 - A' x n m * A x n m.+1)
   + A x n m.+1 * - (A x n m * A' x n.+1 m - A' x n m * A x n.+1 m).
  by move: (A x n.+1 m) (A' x n.+1 m) (A x n m.+1) (A x n m) (A' x n m.+1) (A' x n m) => z1 z2 z3 z4 z5 z6; ring.
by rewrite addr_gt0 // mulr_gt0 // oppr_gt0.
Qed.
(* the corollary without strictness, always *)
Theorem A_ratio x n m : u < x < v -> 0 <= A x n.+1 m * A' x n m.+1 - A' x n.+1 m * A x n m.+1.
Proof.
move=> hx; case: n => [|n]; first by rewrite A_0m A'_0m !mulr0 subrr.
case: m => [|m]; first by rewrite A_n0 A'_n0 !mul0r subrr.
by rewrite ltW // A_ratio_strict.
Qed.

(* G' = A_i - A_(i+1) *)
Theorem G_der x n m : u < x < v -> (G3 x n m).1.2 = A x n.+1 m - A x n m.+1.
Proof.
move=> hx; have := G_C r0 (a0 hx) (b0 hx) n m; rewrite -G3_dual -!C3_dual => ->; by [].
Qed.
(* n = 0 (i = s): rises; m = 0 (i = s - k): falls; degree 0: constant 1 *)
Lemma A_1m_gt0 x m : u < x < v -> (0 < m)%N -> 0 < A x 1 m.
Proof. by move=> hx m0; apply: A_gt0. Qed.
End Table.

(* Theorem 3 over a real closed field. *)
Section Theorem3.
Variable R : rcfType.
Variable r : R.
Hypothesis r0 : 0 < r.
Variables u v : R.
Variables tL tR : nat -> R.
Hypothesis tLu : forall n, tL n <= u.
Hypothesis tRv : forall m, v <= tR m.
Hypothesis tL_mono : forall n, tL n.+1 <= tL n.
Hypothesis tR_mono : forall m, tR m <= tR m.+1.
Notation A x n m := (A r tL tR x n m).
Notation A' x n m := (A' r tL tR x n m).
Notation G x n m := (G3 r tL tR x n m).1.1.      (* G_i^k(x) *)
Notation G' x n m := (G3 r tL tR x n m).1.2.     (* its derivative *)

(* the ratio A_(i+1)/A_i: here as the difference q = A n (m+1)/A n m - A (n+1) m/A n m, strictly increasing *)
Definition q n m x := A x n m.+1 / A x n m - A x n.+1 m / A x n m.
Lemma q_mono n m x y : (0 < n)%N -> (0 < m)%N -> u < x -> x < y -> y < v -> q n m x < q n m y.
Proof.
move=> n0 m0 ux xy yv.
have nz z : u < z < v -> A z n m != 0.
  by move=> hz; rewrite gt_eqF // (A_gt0 r0 tLu tRv hz).
have [_ h0] := C3_der r0 tLu tRv n m; have [_ h1] := C3_der r0 tLu tRv n m.+1.
have [_ h2] := C3_der r0 tLu tRv n.+1 m.
apply: (isd_mono_strict (isd_sub (isd_div h1 h0 nz) (isd_div h2 h0 nz)) ux xy yv) => z /andP[xz zy].
have hz : u < z < v by rewrite (lt_le_trans ux xz) (le_lt_trans zy yv).
have g2 : 0 < (A z n m ^+ 2)^-1 by rewrite invr_gt0 exprn_gt0 // (A_gt0 r0 tLu tRv hz).
have k1 := A_right r0 tLu tRv tR_mono hz n0 m0; have k2 := A_left r0 tLu tRv tL_mono hz n0 m0.
rewrite -mulrBl pmulr_lgt0 // -/(Theorem3Table.A r tL tR z n m) -/(Theorem3Table.A' r tL tR z n m).
rewrite -/(Theorem3Table.A r tL tR z n m.+1) -/(Theorem3Table.A' r tL tR z n m.+1) -/(Theorem3Table.A r tL tR z n.+1 m) -/(Theorem3Table.A' r tL tR z n.+1 m).
move: k1 k2; move: (A z n m) (A' z n m) (A z n m.+1) (A' z n m.+1) (A z n.+1 m) (A' z n.+1 m) => a1 a2 b1 b2 c1 c2 k1 k2.
have -> : b2 * a1 - b1 * a2 - (c2 * a1 - c1 * a2) = (a1 * b2 - a2 * b1) + - (a1 * c2 - a2 * c1) by ring.
by rewrite addr_gt0 // oppr_gt0.
Qed.

(* Theorem 3: the derivative goes from + to - at most once, strictly (degree n + m >= 1) *)
Theorem theorem3 n m x y : (0 < n + m)%N -> u < x -> x < y -> y < v -> G' x n m <= 0 -> G' y n m < 0.
Proof.
move=> nm ux xy yv.
have hx : u < x < v by rewrite ux (lt_trans xy). have hy : u < y < v by rewrite (lt_trans ux).
rewrite (G_der r0 tLu tRv n m hx) (G_der r0 tLu tRv n m hy).
case: n nm => [|n] nm.
  by rewrite A_0m subr0 => h; have := A_gt0 r0 tLu tRv hx (isT : (0 < 1)%N) nm; rewrite ltNge h.
case: m nm => [|m] nm.
  rewrite !A_n0 !sub0r => _; rewrite oppr_lt0; exact: (A_gt0 r0 tLu tRv hy).
have gx : 0 < A x n.+1 m.+1 by apply: (A_gt0 r0 tLu tRv hx).
have gy : 0 < A y n.+1 m.+1 by apply: (A_gt0 r0 tLu tRv hy).
have := @q_mono n.+1 m.+1 x y isT isT ux xy yv.
rewrite /q -!mulrBl => h k.
have : 0 <= (A x n.+1 m.+2 - A x n.+2 m.+1) / A x n.+1 m.+1.
  by rewrite mulr_ge0 ?invr_ge0 ?(ltW gx) // subr_ge0 -subr_le0.
move=> /le_lt_trans /(_ h); rewrite pmulr_lgt0 ?invr_gt0 // subr_gt0 => e.
by rewrite subr_lt0.
Qed.

(* the sign of the derivative does not rise *)
Corollary sign_pattern n m x y : (0 < n + m)%N -> u < x -> x < y -> y < v ->
  Num.sg (G' y n m) <= Num.sg (G' x n m).
Proof.
move=> nm ux xy yv; case: (lerP (G' x n m) 0) => h.
  rewrite (ltr0_sg (theorem3 nm ux xy yv h)).
  by case: sgrP => // _; rewrite ?lerN10 // -subr_ge0 opprK addr_ge0 ?ler01.
rewrite (gtr0_sg h); by case: sgrP => // _; rewrite ?ler01 // -subr_ge0 opprK addr_ge0 ?ler01.
Qed.

(* without derivatives: strictly above the smaller end value, so no local minimum inside the span *)
Theorem unimodal n m x y z : (0 < n + m)%N -> u < x -> x < y -> y < z -> z < v ->
  Num.min (G x n m) (G z n m) < G y n m.
Proof.
move=> nm ux xy yz zv; have [d _] := G3_der r0 tLu tRv n m.
have uy := lt_trans ux xy; have yv := lt_trans yz zv.
rewrite lt_minl; case: (lerP (G' y n m) 0) => h.
  apply/orP; right; rewrite -ltr_opp2.
  (* on [y,z] the derivative is <= 0, and < 0 right of y *)
  pose w := (y + z) / 2%:R.
  have yw : y < w by rewrite midf_lt. have wz : w < z by rewrite midf_lt.
  apply: (@le_lt_trans _ _ (- G w n m)).
    apply: (isd_mono_seg (isd_opp d) uy (ltW yw) (lt_trans wz zv)) => t /andP[yt tw].
    rewrite oppr_ge0; case: (eqVneq y t) => [<- //|ne].
    by apply: ltW; apply: (theorem3 nm uy _ (le_lt_trans tw (lt_trans wz zv)) h); rewrite lt_neqAle ne.
  apply: (isd_mono_strict (isd_opp d) (lt_trans uy yw) wz zv) => t /andP[wt tz].
  rewrite oppr_gt0; exact: (theorem3 nm uy (lt_le_trans yw wt) (le_lt_trans tz zv) h).
apply/orP; left; apply: (isd_mono_strict d ux xy yv) => t /andP[xt ty].
rewrite ltNge; apply/negP => k.
case: (eqVneq t y) => [e|ne]; first by move: h; rewrite -e ltNge k.
have ty' : t < y by rewrite lt_neqAle ne.
have := theorem3 nm (lt_le_trans ux xt) ty' yv k; by rewrite ltNge (ltW h).
Qed.
End Theorem3.
