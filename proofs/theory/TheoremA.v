(* Theorem A for functions of x: y_l(x) = (t_l - x)/lambda_l on an open interval (u,v) without a knot, any weights lambda_l > 0.
   C_V' = AA V, C_V'' = AA' V (theorems AA_der, AA_der2 of Gauge.v).  New knot t0 beyond all of V on the right: AA(t0::V)/AA V
   is strictly increasing; on the left: strictly decreasing (AA V AA' (t0::V) - AA' V AA (t0::V) > 0, < 0). *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower CoreInequality ListRace Lemma7 RationalDerivative Lemma7Functions Mirror Gauge.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.
Local Arguments Tower.D : simpl never.

Section FarAll.
Variable R : realFieldType.
Variables u v : R.
Variable I : eqType.
Variables t lam : I -> R.
Variable sd : I -> bool.
Hypothesis lam0 : forall l, 0 < lam l.
Hypothesis t_sd : forall l, if sd l then v <= t l else t l <= u.
Variables (V : seq I) (t0 : I).
Hypothesis uU : uniq (t0 :: V).
Hypothesis VR : has sd V.
Hypothesis VL : has (fun l => ~~ sd l) V.
Definition sg : R := if sd t0 then 1 else -1.
Hypothesis far : forall l, 0 <= sg * (t t0 - t l).
Notation yy := (yy t lam).
Notation AA := (AA t lam). Notation AA' := (AA' t lam).
Notation U := (t0 :: V).

Lemma sg2 : sg * sg = 1. Proof. by rewrite /sg; case: (sd t0); rewrite ?mulr1 // mulrNN mulr1. Qed.
Lemma sgn0 : sg != 0. Proof. by apply/eqP => h; have := sg2; rewrite h mul0r => /esym/eqP; rewrite oner_eq0. Qed.
Lemma sgV : sg^-1 = sg. Proof. by apply: (mulfI sgn0); rewrite divff ?sgn0 // sg2. Qed.

Definition dd x := sg * (t t0 - x).
Definition gg x := (dd x)^-1.
Lemma dd0 x : u < x < v -> 0 < dd x.
Proof.
case/andP=> ux xv; have := t_sd t0; rewrite /dd /sg; case: (sd t0) => h.
  by rewrite mul1r subr_gt0 (lt_le_trans xv).
by rewrite mulN1r opprB subr_gt0 (le_lt_trans h).
Qed.
Lemma gg0 x : u < x < v -> 0 < gg x. Proof. by move=> hx; rewrite invr_gt0 dd0. Qed.
Lemma dd_der : isd u v dd (fun _ => - sg).
Proof.
apply: (isd_ext (isd_scale sg (isd_sub (isd_const u v (t t0)) (isd_id u v)))) => x hx //.
by rewrite sub0r mulrN1.
Qed.
Lemma gg_der : isd u v gg (fun x => sg * gg x ^+ 2).
Proof.
apply: (isd_ext (isd_inv dd_der _)) => [x hx|x hx //|x hx]; first by rewrite gt_eqF ?dd0.
by rewrite opprK /gg exprVn.
Qed.

Definition ee l := sg * (t t0 - t l) / lam l.
Lemma ee0 l : 0 <= ee l. Proof. by rewrite divr_ge0 ?far // ltW. Qed.
Lemma eet0 : ee t0 = 0. Proof. by rewrite /ee subrr mulr0 mul0r. Qed.
Definition zz x l := gg x * yy x l.
Definition cc x l := gg x ^+ 2 * ee l.
Lemma zz_sd x l : u < x < v -> if sd l then 0 < zz x l else zz x l < 0.
Proof.
move=> hx; have := yy_sd lam0 t_sd l hx; have g := gg0 hx.
by case: (sd l) => h; rewrite /zz; [apply: mulr_gt0 | rewrite pmulr_rlt0].
Qed.
Lemma zz_der l : isd u v (fun x => zz x l) (fun x => - cc x l).
Proof.
apply: (isd_ext (isd_mul gg_der (yy_der u v t lam l))) => x hx //.
have d : dd x != 0 by rewrite gt_eqF ?dd0.
have ll : lam l != 0 by rewrite gt_eqF.
have e : t t0 - x = sg * dd x by rewrite /dd mulrA sg2 mul1r.
rewrite /cc /ee /Gauge.yy /gg.
have -> : t l - x = sg * dd x - (t t0 - t l) by rewrite -e; ring.
have -> : - ((dd x)^-1 ^+ 2 * (sg * (t t0 - t l) / lam l)) = (sg * sg - 1) * ((dd x)^-1 / lam l) - ((dd x)^-1 ^+ 2 * (sg * (t t0 - t l) / lam l)) by rewrite sg2 subrr mul0r sub0r.
by move: d ll; move: (dd x) (lam l) (t t0 - t l) sg => a b c s a0 b0; field; rewrite a0 b0.
Qed.
Lemma zzt0 x : u < x < v -> zz x t0 = sg / lam t0.
Proof.
move=> hx; have d : dd x != 0 by rewrite gt_eqF ?dd0.
have ll : lam t0 != 0 by rewrite gt_eqF.
rewrite /zz /Gauge.yy /gg; have -> : t t0 - x = sg * dd x by rewrite /dd mulrA sg2 mul1r.
by move: d ll; move: (dd x) (lam t0) sg => a b s a0 b0; field; rewrite a0 b0.
Qed.
Lemma zz_side x : u < x < v -> forall l, lft (zz x) l || rgt (zz x) l.
Proof. by move=> hx; apply: (y_side zz_sd hx). Qed.

Notation DZ x := (Tower.D (zz x) (ListRace.C (zz x))).
Definition ff W x := \sum_(l <- V) ee l * DZ x 1 (l :: W).
Definition FF W x := \sum_(l <- V) \sum_(m <- V) ee l * ee m * (1 + (l == m)%:R) * DZ x 2 (l :: m :: W).
Definition VU W := W = V \/ W = U.
Lemma uV : uniq V. Proof. by case/andP: uU. Qed.
Lemma sz W : VU W -> (0 < size W)%N.
Proof. by case=> ->; rewrite //; case: (V) VR. Qed.

Lemma sumVU W (e F : I -> R) : VU W -> e t0 = 0 -> \sum_(m <- W) e m * F m = \sum_(m <- V) e m * F m.
Proof. by case=> -> // e0; rewrite big_cons e0 mul0r add0r. Qed.

Lemma ff_der W : VU W -> isd u v (ff W) (fun x => gg x ^+ 2 * FF W x).
Proof.
move=> hW.
have h l := isd_scale (ee l) (lemma7_fun zz_sd zz_der (j:=1) (s := l :: W) (sz hW)).
apply: (isd_ext (isd_sum V h)) => x hx //.
rewrite /FF -(dbl ee (F := fun l m => DZ x 2 (l :: m :: W)) uV).
  rewrite mulr_sumr; apply: eq_bigr => l _.
  rewrite mulrCA; congr (_ * _); rewrite mulr_sumr !big_cons /cc mulrA; congr (_ + _).
  rewrite (sumVU (fun m => DZ x 2 (m :: l :: W)) hW) ?eet0 ?mulr0 //; by apply: eq_bigr => m _; rewrite mulrA.
by move=> l m; apply: (DDperm (zz_side hx)); rewrite (perm_catCA [:: l] [:: m]).
Qed.

Lemma uVU W : VU W -> uniq W. Proof. by case=> ->; rewrite ?uV. Qed.

Lemma AA_eq W x : VU W -> u < x < v -> AA x W = gg x ^+ 2 * ff W x.
Proof.
move=> hW hx; have h1 := AA_der lam0 t_sd (sz hW).
have h2 := lemma7_fun zz_sd zz_der (j:=0) (s := W) (sz hW).
have e z : u < z < v -> ListRace.C (yy z) W = DZ z 0 W.
  by move=> hz; apply: esym; apply: (C_scale _ _ (gg0 hz)).
rewrite (isd_uniq h1 h2 e hx) (sumVU (fun m => DZ x 1 (m :: W)) hW) /cc ?eet0 ?mulr0 //.
by rewrite /ff mulr_sumr; apply: eq_bigr => l _; rewrite -mulrA.
Qed.

Lemma AA'_eq W x : VU W -> u < x < v ->
  AA' x W = 2%:R * sg * gg x ^+ 3 * ff W x + gg x ^+ 4 * FF W x.
Proof.
move=> hW hx; have h1 := AA_der2 lam0 t_sd (uVU hW) (sz hW).
have h2 := isd_mul (isd_mul gg_der gg_der) (ff_der hW).
have e z : u < z < v -> AA z W = gg z * gg z * ff W z by move=> hz; rewrite AA_eq.
rewrite (isd_uniq h1 h2 e hx).
by move: (gg x) (ff W x) (FF W x) => g f F; ring.
Qed.

Lemma all_eq x : u < x < v -> sg * (AA x V * AA' x U - AA' x V * AA x U) =
  gg x ^+ 6 * lam t0 * (zz x t0 * (ff V x * FF U x - FF V x * ff U x)).
Proof.
move=> hx; have hV : VU V by left. have hU : VU U by right.
rewrite !AA_eq // !AA'_eq // zzt0 //.
have ll : lam t0 != 0 by rewrite gt_eqF.
by move: ll; move: (lam t0) (gg x) (ff V x) (ff U x) (FF V x) (FF U x) sg => e g a b c d s e0; field.
Qed.
Lemma twoV x : u < x < v -> two (zz x) V.
Proof.
move=> hx; apply/andP; split.
  by rewrite (eq_has (a2 := fun l => ~~ sd l)) // => l; rewrite (lftE zz_sd).
by rewrite (eq_has (a2 := sd)) // => l; rewrite (rgtE zz_sd).
Qed.
(* Theorem A for functions of x: one more knot, farther than all others, the inequality for all indices *)
Theorem theoremA_all x : u < x < v ->
  0 <= sg * (AA x V * AA' x U - AA' x V * AA x U).
Proof.
move=> hx; rewrite all_eq //; apply: mulr_ge0.
  by rewrite mulr_ge0 ?exprn_ge0 // ltW // gg0.
exact: (theoremA_signed (zz_side hx) t0 uV (twoV hx) ee0).
Qed.
(* the same, strict *)
Theorem theoremA_all_strict x : u < x < v ->
  0 < sg * (AA x V * AA' x U - AA' x V * AA x U).
Proof.
move=> hx; rewrite all_eq //; apply: mulr_gt0.
  by rewrite mulr_gt0 ?exprn_gt0 // gg0.
have uv : u < v by case/andP: hx => h1 h2; apply: lt_trans h2.
have [l lV sl] : exists2 l, l \in V & sd l != sd t0.
  by case: (sd t0); [case/hasP: VL | case/hasP: VR] => l lV hl; exists l => //; rewrite ?hl // (negbTE hl).
apply: (theoremA_signed_strict (zz_side hx) uV (twoV hx) ee0 lV).
  rewrite /ee divr_gt0 // /sg; have := t_sd l; have := t_sd t0.
  move: sl; case: (sd t0); case: (sd l) => // _ h1 h2; rewrite ?mul1r ?mulN1r ?opprB subr_gt0.
    by rewrite (le_lt_trans h2) // (lt_le_trans uv).
  by rewrite (le_lt_trans h1) // (lt_le_trans uv).
by rewrite !(rgtE zz_sd).
Qed.
End FarAll.

(* only the members of V need to lie on the near side of t0 *)
Section Far.
Variable R : realFieldType.
Variables u v : R.
Variable I : eqType.
Variables t lam : I -> R.
Variable sd : I -> bool.
Hypothesis lam0 : forall l, 0 < lam l.
Hypothesis t_sd : forall l, if sd l then v <= t l else t l <= u.
Variables (V : seq I) (t0 : I).
Hypothesis uU : uniq (t0 :: V).
Hypothesis VR : has sd V.
Hypothesis VL : has (fun l => ~~ sd l) V.
Notation AA := (AA t lam). Notation AA' := (AA' t lam).
Notation U := (t0 :: V).

Lemma AA_ext (t1 : I -> R) W x : {in W, t1 =1 t} -> Gauge.AA t1 lam x W = AA x W.
Proof.
move=> h; rewrite /Gauge.AA big_seq [RHS]big_seq; apply: eq_bigr => l lW; congr (_ * _).
by apply: D_ext => m; rewrite inE => /orP[/eqP ->|mW]; rewrite /yy h.
Qed.
Lemma AA'_ext (t1 : I -> R) W x : {in W, t1 =1 t} -> Gauge.AA' t1 lam x W = AA' x W.
Proof.
move=> h; rewrite /Gauge.AA' big_seq [RHS]big_seq; apply: eq_bigr => l lW.
rewrite big_seq [RHS]big_seq; apply: eq_bigr => m mW; congr (_ * _).
by apply: D_ext => q; rewrite !inE => /or3P[/eqP ->|/eqP ->|qW]; rewrite /yy h.
Qed.

(* only the members of V have to lie on the near side of the new knot *)
Theorem theoremA_fun x : (forall l, l \in V -> 0 <= sg R sd t0 * (t t0 - t l)) -> u < x < v ->
  0 < sg R sd t0 * (AA x V * AA' x U - AA' x V * AA x U).
Proof.
move=> far hx.
pose t1 l := if l \in U then t l else t t0.
pose sd1 l := if l \in U then sd l else sd t0.
have tin l : l \in U -> t1 l = t l by rewrite /t1 => ->.
have sin l : l \in U -> sd1 l = sd l by rewrite /sd1 => ->.
have inU l : l \in V -> l \in U by rewrite inE orbC => ->.
have ts1 l : if sd1 l then v <= t1 l else t1 l <= u.
  by rewrite /t1 /sd1; case: (l \in U); apply: t_sd.
have VR1 : has sd1 V by rewrite (eq_in_has (a2 := sd)) // => l lV; rewrite sin // inU.
have VL1 : has (fun l => ~~ sd1 l) V by rewrite (eq_in_has (a2 := fun l => ~~ sd l)) // => l lV; rewrite sin // inU.
have e0 : sg R sd1 t0 = sg R sd t0 by rewrite /sg sin // mem_head.
have far1 l : 0 <= sg R sd1 t0 * (t1 t0 - t1 l).
  rewrite e0 (tin t0) ?mem_head // /t1; case: ifP => [|_]; last by rewrite subrr mulr0.
  by rewrite inE => /orP[/eqP ->|]; [rewrite subrr mulr0 | apply: far].
have := theoremA_all_strict lam0 ts1 uU VR1 VL1 far1 hx.
have tV : {in V, t1 =1 t} by move=> l /inU; apply: tin.
have tU : {in U, t1 =1 t} by move=> l; apply: tin.
by rewrite e0 !(AA_ext _ tV) !(AA_ext _ tU) !(AA'_ext _ tV) !(AA'_ext _ tU).
Qed.

(* a new knot on the right: the ratio of the derivatives rises *)
Corollary theoremA_fun_right x : sd t0 -> (forall l, l \in V -> t l <= t t0) -> u < x < v ->
  0 < AA x V * AA' x U - AA' x V * AA x U.
Proof.
move=> h far hx; have := @theoremA_fun x; rewrite /sg h mul1r; apply=> // l lV.
by rewrite mul1r subr_ge0 far.
Qed.
(* a new knot on the left: it falls *)
Corollary theoremA_fun_left x : ~~ sd t0 -> (forall l, l \in V -> t t0 <= t l) -> u < x < v ->
  AA x V * AA' x U - AA' x V * AA x U < 0.
Proof.
move=> h far hx; have := @theoremA_fun x; rewrite /sg (negbTE h) mulN1r oppr_gt0; apply=> // l lV.
by rewrite mulN1r opprB subr_ge0 far.
Qed.

(* C_V' > 0 *)
Lemma AA_gt0 x : u < x < v -> 0 < AA x V.
Proof.
move=> hx; have ys := y_side (yy_sd lam0 t_sd) hx.
have tV : two (yy t lam x) V.
  apply/andP; split.
    by rewrite (eq_has (a2 := fun l => ~~ sd l)) // => l; rewrite (lftE (yy_sd lam0 t_sd)).
  by rewrite (eq_has (a2 := sd)) // => l; rewrite (rgtE (yy_sd lam0 t_sd)).
have pos l : 0 < (lam l)^-1 * Tower.D (yy t lam x) (ListRace.C (yy t lam x)) 1 (l :: V).
  by rewrite mulr_gt0 ?invr_gt0 // (DDpos ys) // two_cons.
rewrite /Gauge.AA; case: (V) VR pos => [//|l s] _ pos; rewrite big_cons.
by apply: ltr_paddr; [apply: sumr_ge0 => m _; apply: ltW; apply: pos | apply: pos].
Qed.
End Far.
