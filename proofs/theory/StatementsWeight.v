(* The claims about the weight (section 2) that Weight.v does not state: phi.shape, L2.1, R2.2. No degree occurs in them. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values RationalDerivative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Statements.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Implicit Types a b c x al : R.

Lemma dmob_gt0 x a b : a <= x -> x <= b -> a < b -> 0 < dmob r x a b.
Proof. by move=> ax xb ab; rewrite divr_gt0 ?exprn_gt0 ?mob_den_gt0 // mulr_gt0 // subr_gt0. Qed.
(* phi.shape: rising from 0 to its limit 1 with a positive derivative, 0 outside of [a,b) *)
Theorem phi_shape_printed a b : a < b ->
  [/\ forall x, a < x < b -> exists2 l, 0 < l & left_taylor (fun y => phi r y a b) x (phi r x a b) l /\ right_taylor (fun y => phi r y a b) x (phi r x a b) l,
      forall x, ~~ (a <= x < b) -> phi r x a b = 0,
      phi r a a b = 0 /\ exists l, right_taylor (fun y => phi r y a b) a 0 l &
      exists l, left_taylor (fun y => phi r y a b) b 1 l].
Proof.
move=> ab; pose t (i : nat) := if i == 0%N then a else b.
have Rt x := wDrightP r_gt0 t 1 0 x; have Lt x := wDleftP r_gt0 t 1 0 x; rewrite /wDright /wDleft /= in Rt Lt.
split.
- move=> x /andP[x1 x2]; exists (dmob r x a b); first by rewrite dmob_gt0 ?ltW.
  split; last by have := Rt x; rewrite /= (ltW x1) x2.
  by have := Lt x; rewrite /= x1 (ltW x2) phi_in // (ltW x1).
- by move=> x /negbTE h; rewrite /phi h.
- by split; [rewrite phi_a|exists (dmob r a a b); have := Rt a; rewrite /= lexx ab /wt /= phi_a].
by exists (dmob r b a b); have := Lt b; rewrite /= lexx ab /mw /= mob_b.
Qed.
(* R2.2.1 *)
Theorem R2_2_1_printed al a b x : al < 0 \/ 1 < al -> a < b -> a <= x <= b -> x + (al - 1) * b - al * a != 0.
Proof.
move=> h ab /andP[ax xb]; have e1 := al_neq1 h; have r0 := D2_3_r_gt0 h.
have -> : x + (al - 1) * b - al * a = (al - 1) * (al / (al - 1) * (x - a) + (b - x)) by field.
by rewrite mulf_neq0 // mob_den_neq0.
Qed.
(* R2.2.2a *)
Theorem R2_2_2a_printed a b x : a < b -> a <= x <= b ->
  [/\ taylor (fun y => mob r y a b) x (mob r x a b) (dmob r x a b), 0 < dmob r x a b, mob r a a b = 0 & mob r b a b = 1].
Proof. by move=> ab /andP[ax xb]; split; rewrite ?mob_a ?mob_b ?dmob_gt0 //; exact: mob_taylor. Qed.
(* R2.2.2b: the distance from the classical weight is at most |r-1| *)
Theorem R2_2_2b_printed a b x : a < b -> a <= x <= b -> `|mob r x a b - (x - a) / (b - a)| <= `|r - 1|.
Proof.
move=> ab /andP[ax xb]; have d1 := mob_den_gt0 r_gt0 ax xb ab; have ba : 0 < b - a by rewrite subr_gt0.
set u := x - a in d1 *; set v := b - x in d1 *.
have u0 : 0 <= u by rewrite subr_ge0. have v0 : 0 <= v by rewrite subr_ge0.
have eb : b - a = u + v by rewrite /u /v; ring.
rewrite eb in ba *.
have n1 : r * u + v != 0 by rewrite gt_eqF. have n2 : u + v != 0 by rewrite gt_eqF.
have -> : mob r x a b - u / (u + v) = (r - 1) * (u * v / ((r * u + v) * (u + v))).
  by rewrite /mob -/u -/v; field; rewrite n1 n2.
rewrite normrM -[X in _ <= X]mulr1 ler_wpmul2l // ger0_norm; last by rewrite divr_ge0 ?mulr_ge0 // ltW.
rewrite ler_pdivr_mulr ?mulr_gt0 // mul1r mulrC ler_pmul // ?ler_addl ?ler_addr ?mulr_ge0 // ltW //.
Qed.
(* R2.2.2c: reflection *)
Theorem R2_2_2c_printed a b x : a < b -> a <= x <= b ->
  mob r (a + b - x) a b = 1 - mob r^-1 x a b /\ mob r x a b = 1 - mob r^-1 (a + b - x) a b.
Proof.
move=> ab /andP[ax xb].
have M y : a <= y -> y <= b -> mob r (a + b - y) a b = 1 - mob r^-1 y a b.
  move=> ay yb; rewrite -(mob_mirror r_gt0 ay yb ab).
  by rewrite -(@mob_affine R r (- y) (- b) (- a) 1 (a + b) (oner_neq0 R)); congr (mob r _ _ _); ring.
split; first exact: M.
have y1 : a <= a + b - x by rewrite -addrA ler_addl subr_ge0.
have y2 : a + b - x <= b by rewrite addrAC ger_addr subr_le0.
by rewrite -M //; congr (mob r _ a b); ring.
Qed.
End Statements.

(* The homographic functions with f(a) = 0, f(b) = 1 and their pole c outside of [a,b] are the f_alpha, alpha = (b-c)/(b-a), each of them
   for one alpha only *)
Theorem L2_1_homographic (R : realFieldType) (a b c : R) : a < b -> ~~ (a <= c <= b) -> let al := (b - c) / (b - a) in
  [/\ al < 0 \/ 1 < al, forall x, a <= x <= b -> f_alpha al x a b = (b - c) * (x - a) / ((b - a) * (x - c)) &
      forall al', al' < 0 \/ 1 < al' -> (forall x, a <= x <= b -> f_alpha al' x a b = (b - c) * (x - a) / ((b - a) * (x - c))) -> al' = al].
Proof.
move=> ab hc al; have ba : 0 < b - a by rewrite subr_gt0. have ban : b - a != 0 by rewrite gt_eqF.
have ok : al < 0 \/ 1 < al.
  move: hc; rewrite negb_and -!ltNge => /orP[ca|bc]; [right|left].
    by rewrite ltr_pdivl_mulr // mul1r ltr_add2l ltr_opp2.
  by rewrite pmulr_llt0 ?invr_gt0 // subr_lt0.
have pole x : a <= x <= b -> x - c != 0.
  by move=> /andP[x1 x2]; rewrite subr_eq0; apply: contraNneq hc => <-; rewrite x1.
have F x : a <= x <= b -> f_alpha al x a b = (b - c) * (x - a) / ((b - a) * (x - c)).
  move=> hx; have p := pole x hx; rewrite /f_alpha.
  have -> : x + (al - 1) * b - al * a = x - c by rewrite /al; field.
  by rewrite /al; field; rewrite ban p.
split=> // al' ok' H.
have r0 := D2_3_r_gt0 ok; have r0' := D2_3_r_gt0 ok'.
have mid : a <= (a + b) / 2%:R <= b by rewrite !midf_le ?ltW.
have E : mob (al' / (al' - 1)) ((a + b) / 2%:R) a b = mob (al / (al - 1)) ((a + b) / 2%:R) a b.
  have /andP[m1 m2] := mid; rewrite -!D2_3_forms // H // F //.
have M q : 0 < q -> mob q ((a + b) / 2%:R) a b = q / (q + 1).
  move=> q0; have qn : q + 1 != 0 by rewrite gt_eqF // addr_gt0 ?ltr01.
  rewrite /mob; have -> : (a + b) / 2%:R - a = (b - a) / 2%:R by field.
  have -> : b - (a + b) / 2%:R = (b - a) / 2%:R by field.
  have hn : (b - a) / 2%:R != 0 by rewrite mulf_neq0 // invr_eq0 pnatr_eq0.
  move: ((b - a) / 2%:R) hn => h hn; have -> : q * h + h = (q + 1) * h by ring.
  by rewrite -mulf_div divff // mulr1.
rewrite !M // in E; have e1 := al_neq1 ok; have e1' := al_neq1 ok'.
have S (q : R) : q != 1 -> q / (q - 1) / (q / (q - 1) + 1) = q / (2%:R * q - 1).
  move=> q1; have n : q - 1 != 0 by rewrite subr_eq0.
  have -> : q / (q - 1) + 1 = (2%:R * q - 1) / (q - 1) by field.
  by rewrite invf_div mulrA divfK.
have d (q : R) : q < 0 \/ 1 < q -> 2%:R * q - 1 != 0.
  case=> h; first by rewrite lt_eqF // subr_lt0 (lt_trans _ ltr01) // pmulr_rlt0 // ltr0n.
  by rewrite gt_eqF // subr_gt0 (lt_trans h) // ltr_pmull ?ltr1n // (lt_trans ltr01).
rewrite subr_eq0 in e1; rewrite subr_eq0 in e1'; rewrite (S _ e1) (S _ e1') in E.
move/eqP: E; rewrite eqr_div ?d // => /eqP E.
apply/eqP; rewrite -subr_eq0; have : al' * (2%:R * al - 1) - al * (2%:R * al' - 1) = 0 by rewrite E subrr.
by have -> : al' * (2%:R * al - 1) - al * (2%:R * al' - 1) = - (al' - al) by [ring]; move/eqP; rewrite oppr_eq0.
Qed.
(* L2.1: and every f_alpha increases, from f(a) = 0 to f(b) = 1 *)
Theorem L2_1_printed (R : realFieldType) (r a b c : R) : 0 < r -> a < b -> ~~ (a <= c <= b) -> let al := (b - c) / (b - a) in
  [/\ [/\ mob r a a b = 0, mob r b a b = 1 & forall x, a <= x <= b -> taylor (fun y => mob r y a b) x (mob r x a b) (dmob r x a b) /\ 0 < dmob r x a b],
      al < 0 \/ 1 < al, forall x, a <= x <= b -> f_alpha al x a b = (b - c) * (x - a) / ((b - a) * (x - c)) &
      forall al', al' < 0 \/ 1 < al' -> (forall x, a <= x <= b -> f_alpha al' x a b = (b - c) * (x - a) / ((b - a) * (x - c))) -> al' = al].
Proof.
move=> r0 ab hc al; have [h1 h2 h3] := L2_1_homographic ab hc; split=> //; split=> [||x hx]; rewrite ?mob_a ?mob_b //.
by have [] := R2_2_2a_printed r0 ab hx.
Qed.
(* Ill2.1: the second derivative of the weight on (a,b) is positive for alpha < 0, negative for alpha > 1 *)
Theorem Ill2_1_printed (R : realFieldType) (al a b : R) : al < 0 \/ 1 < al -> a < b -> exists F1 F2,
  [/\ isd a b (fun x => phi_alpha al x a b) F1, isd a b F1 F2 &
      forall x, a < x < b -> (al < 0 -> 0 < F2 x) /\ (1 < al -> F2 x < 0)].
Proof.
move=> h ab; have r0 := D2_3_r_gt0 h; have e1 := al_neq1 h; set r := al / (al - 1) in r0.
pose D x := r * (x - a) + (b - x).
have D0 x : a < x < b -> 0 < D x by move=> /andP[ax xb]; rewrite /D mob_den_gt0 // ltW.
have dx : isd a b (fun x => x - a) (fun _ => 1 - 0) := isd_sub (isd_id a b) (isd_const a b a).
have dD : isd a b D (fun _ => r * (1 - 0) + (0 - 1)) := isd_add (isd_scale r dx) (isd_sub (isd_const a b b) (isd_id a b)).
have nD x : a < x < b -> D x != 0 by move=> hx; rewrite gt_eqF // D0.
have nD2 x : a < x < b -> D x * D x != 0 by move=> hx; rewrite mulf_neq0 // nD.
exists (fun x => r * (b - a) / (D x * D x)), (fun x => (2%:R * r * (1 - r) * (b - a)) / D x ^+ 3); split.
- apply: (isd_ext (isd_div (isd_scale r dx) dD nD)) => x hx.
    by have /andP[ax xb] := hx; rewrite D2_3 // phi_in ?(ltW ax).
  have n := nD x hx; rewrite -[b - a](_ : D x - (r - 1) * (x - a) = _); last by rewrite /D; ring.
  by move: (D x) n => c n; field.
- apply: (isd_ext (isd_div (isd_const a b (r * (b - a))) (isd_mul dD dD) nD2)) => x hx //.
  by have n := nD x hx; move: (D x) n => c n; field.
move=> x hx; have D3 : 0 < D x ^+ 3 by rewrite exprn_gt0 // D0.
have c0 : 0 < 2%:R * r by rewrite mulr_gt0 ?ltr0n. have c1 : 0 < b - a by rewrite subr_gt0.
have E : 1 - r = - (al - 1)^-1 by rewrite /r; field.
split=> ha; rewrite E.
  by rewrite divr_gt0 // mulr_gt0 // mulr_gt0 // oppr_gt0 invr_lt0 subr_lt0 (lt_trans ha) ?ltr01.
rewrite pmulr_llt0 ?invr_gt0 // pmulr_llt0 // pmulr_rlt0 // oppr_lt0 invr_gt0 subr_gt0 //.
Qed.
