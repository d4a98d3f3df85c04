(* The gauge: multiplying all y_l by k > 0 leaves C unchanged (D_j is divided by k^j);
   hence Theorem A for functions of x, with y_l(x) = (t_l - x)/lambda_l, any weights, far knot on either side. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower CoreInequality ListRace Lemma7 RationalDerivative Lemma7Functions Mirror.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.
Local Arguments Tower.D : simpl never.

Section Scale.
Variable R : realFieldType.
Lemma cl_scale (k : R) A B : k != 0 -> cl [seq k * a | a <- A] [seq k * b | b <- B] = cl A B.
Proof.
move=> k0; elim: A B => [|a A IHA] B //; elim: B => [|b B IHB] //.
rewrite !map_cons !clE -!map_cons IHB IHA.
by rewrite -mulrDr -!mulrA -mulrDr -mulf_div divff // mul1r.
Qed.

Variable I : eqType.
Lemma C_scale (k : R) (y : I -> R) s : 0 < k -> ListRace.C (fun l => k * y l) s = ListRace.C y s.
Proof.
move=> k0; rewrite /ListRace.C /Ls /Rs.
have -> : [seq l <- s | lft (fun l => k * y l) l] = [seq l <- s | lft y l].
  by apply: eq_filter => l; rewrite /lft pmulr_rlt0.
have -> : [seq l <- s | rgt (fun l => k * y l) l] = [seq l <- s | rgt y l].
  by apply: eq_filter => l; rewrite /rgt pmulr_rgt0.
rewrite -[RHS](@cl_scale k _ _ (lt0r_neq0 k0)) -!map_comp; congr (cl _ _); apply: eq_map => l //=.
by rewrite mulrN.
Qed.

(* all signed distances times c > 0: D_j is divided by c^j *)
Theorem D_scale (k : R) (y : I -> R) j s : (forall l, lft y l || rgt y l) -> 0 < k ->
  Tower.D (fun l => k * y l) (ListRace.C (fun l => k * y l)) j s = Tower.D y (ListRace.C y) j s / k ^+ j.
Proof.
move=> ys k0; elim: j s => [|j IH] s; first by rewrite expr0 divr1; apply: C_scale.
case: (ltnP j.+1 (size s)) => [|h]; last by rewrite /Tower.D; case: j h IH => [|j] h _; rewrite h mul0r.
case: s => [//|l s] h; rewrite /= ltnS in h.
rewrite !DE // !IH exprS; have yl := yn0 ys l; have kn : k != 0 by rewrite gt_eqF.
have en : k ^+ j != 0 by rewrite expf_neq0.
by move: en; move: (k ^+ j) (Tower.D _ _ _ s) (Tower.D _ _ _ (l :: s)) => e X Y en; field; rewrite kn yl en.
Qed.

(* C and D see only the members of the list *)
Lemma C_ext (y y' : I -> R) s : {in s, y =1 y'} -> ListRace.C y s = ListRace.C y' s.
Proof.
move=> h; rewrite /ListRace.C /Ls /Rs.
have e1 : [seq l <- s | lft y l] = [seq l <- s | lft y' l].
  by apply: eq_in_filter => l ls; rewrite /lft h.
have e2 : [seq l <- s | rgt y l] = [seq l <- s | rgt y' l].
  by apply: eq_in_filter => l ls; rewrite /rgt h.
rewrite e1 e2; congr (cl _ _); apply/eq_in_map => l; rewrite mem_filter => /andP[_ ls]; by rewrite h.
Qed.
Lemma D_ext (y y' : I -> R) j s : {in s, y =1 y'} -> Tower.D y (ListRace.C y) j s = Tower.D y' (ListRace.C y') j s.
Proof.
elim: j s => [|j IH] s h; first exact: C_ext.
case: (ltnP j.+1 (size s)) => [|z]; last by rewrite /Tower.D; case: j z IH => [|j] z _; rewrite z.
case: s h => [//|l s] h z; rewrite /= ltnS in z.
rewrite !DE // !IH //; first by rewrite (h l) // mem_head.
by move=> m ms; apply: h; rewrite inE ms orbT.
Qed.
End Scale.

Section Far.
Variable R : realFieldType.
Variables u v : R.
Variable I : eqType.
Variables t lam : I -> R.           (* knots and weights *)
Variable sd : I -> bool.            (* true: right *)
Hypothesis lam0 : forall l, 0 < lam l.
Hypothesis t_sd : forall l, if sd l then v <= t l else t l <= u.
Definition yy x l := (t l - x) / lam l.
Notation DDx x := (Tower.D (yy x) (ListRace.C (yy x))).
Definition AA x V := \sum_(l <- V) (lam l)^-1 * DDx x 1 (l :: V).
Definition AA' x V := \sum_(l <- V) \sum_(m <- V) (lam l)^-1 * (lam m)^-1 * (1 + (l == m)%:R) * DDx x 2 (l :: m :: V).

Lemma yy_sd x l : u < x < v -> if sd l then 0 < yy x l else yy x l < 0.
Proof.
case/andP=> ux xv; have := t_sd l; case: (sd l) => h; rewrite /yy.
  by rewrite divr_gt0 // subr_gt0 (lt_le_trans xv).
by rewrite pmulr_llt0 ?invr_gt0 // subr_lt0 (le_lt_trans h).
Qed.
Lemma yy_der l : isd u v (fun x => yy x l) (fun x => - (lam l)^-1).
Proof.
apply: (isd_ext (isd_scale (lam l)^-1 (isd_sub (isd_const u v (t l)) (isd_id u v)))) => x hx.
  by rewrite /yy mulrC.
by rewrite sub0r mulrN1.
Qed.

(* one x-dependent scale c x l = g x * e l: first and second sums *)
Lemma dbl (V : seq I) (e : I -> R) (F : I -> I -> R) : uniq V -> (forall l m, F l m = F m l) ->
  \sum_(l <- V) (e l * \sum_(m <- l :: V) (e m * F m l)) =
  \sum_(l <- V) \sum_(m <- V) e l * e m * (1 + (l == m)%:R) * F l m.
Proof.
move=> uV Fs; rewrite big_seq [RHS]big_seq; apply: eq_bigr => l lV.
rewrite big_cons mulrDr mulr_sumr.
have -> : \sum_(m <- V) e l * e m * (1 + (l == m)%:R) * F l m =
  \sum_(m <- V) e l * (e m * F m l) + \sum_(m <- V) (l == m)%:R * (e l * (e m * F m l)).
  rewrite -big_split /=; apply: eq_bigr => m _; rewrite (Fs m l); ring.
rewrite addrC; congr (_ + _).
rewrite (bigD1_seq l) //= eqxx mul1r big1 ?addr0 // => m ml.
by rewrite eq_sym (negbTE ml) mul0r.
Qed.

Lemma AA_der V : (0 < size V)%N -> isd u v (fun x => ListRace.C (yy x) V) (fun x => AA x V).
Proof. by move=> z; apply: (lemma7_fun yy_sd yy_der (j:=0)). Qed.

Lemma AA_der2 V : uniq V -> (0 < size V)%N -> isd u v (fun x => AA x V) (fun x => AA' x V).
Proof.
move=> uV z.
have h l := isd_scale (lam l)^-1 (lemma7_fun yy_sd yy_der (j:=1) (s := l :: V) z).
apply: (isd_ext (isd_sum V h)) => x hx //.
rewrite /AA' -(dbl (fun l => (lam l)^-1) (F := fun l m => DDx x 2 (l :: m :: V))) //.
by move=> l m; apply: (DDperm (y_side yy_sd hx)); rewrite (perm_catCA [:: l] [:: m]).
Qed.
End Far.
