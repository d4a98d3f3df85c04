(* The weight: D2.3, phi.range, phi.shape, P2.1, C2.4, R2.2. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- the weight: the two forms agree (D2.3) ---- *)
Section Weight.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.

Lemma mob_den_gt0 (x a b : R) : a <= x -> x <= b -> a < b -> 0 < r * (x - a) + (b - x).
Proof.
move=> ax xb ab; case: (ltP a x) => h.
  by rewrite ltr_paddr ?subr_ge0 // mulr_gt0 // subr_gt0.
have -> : x = a by apply/eqP; rewrite eq_le h ax.
by rewrite subrr mulr0 add0r subr_gt0.
Qed.
Lemma mob_den_neq0 (x a b : R) : a <= x -> x <= b -> a < b -> r * (x - a) + (b - x) != 0.
Proof. by move=> *; rewrite gt_eqF // mob_den_gt0. Qed.

Lemma mob_a a b : mob r a a b = 0. Proof. by rewrite /mob subrr mulr0 mul0r. Qed.
Lemma mob_b a b : a < b -> mob r b a b = 1.
Proof. by move=> ab; rewrite /mob subrr addr0 divff // mulf_neq0 ?gt_eqF // subr_gt0. Qed.
Lemma mob_gt0 x a b : a < x -> x <= b -> 0 < mob r x a b.
Proof.
move=> ax xb; rewrite /mob divr_gt0 ?mulr_gt0 ?subr_gt0 // mob_den_gt0 ?(ltW ax) //.
exact: lt_le_trans xb.
Qed.
Lemma mob_lt1 x a b : a <= x -> x < b -> mob r x a b < 1.
Proof.
move=> ax xb; have ab := le_lt_trans ax xb.
by rewrite /mob ltr_pdivr_mulr ?mob_den_gt0 ?(ltW xb) // mul1r ltr_addl subr_gt0.
Qed.
Lemma mob_ge0 x a b : a <= x -> x <= b -> 0 <= mob r x a b.
Proof.
move=> ax xb; have r0 := ltW r_gt0.
apply: divr_ge0; first by rewrite mulr_ge0 ?subr_ge0.
by rewrite addr_ge0 ?subr_ge0 // mulr_ge0 ?subr_ge0.
Qed.
(* 1 - w = (b-x)/(r(x-a)+(b-x)) and the conjugate *)
Lemma mob_compl x a b : a <= x -> x <= b -> a < b -> 1 - mob r x a b = (b - x) / (r * (x - a) + (b - x)).
Proof. by move=> h1 h2 h3; have := mob_den_neq0 h1 h2 h3; rewrite /mob => h; field. Qed.

Lemma phi_range x a b : 0 <= phi r x a b < 1.
Proof.
rewrite /phi; case: ifP => [/andP[h1 h2]|_]; last by rewrite lexx ltr01.
by rewrite mob_ge0 ?mob_lt1 // ltW.
Qed.
Lemma phi_in x a b : a <= x < b -> phi r x a b = mob r x a b.
Proof. by rewrite /phi => ->. Qed.
Lemma phi_a a b : phi r a a b = 0.
Proof. by rewrite /phi; case: ifP => _; rewrite ?mob_a. Qed.
End Weight.

(* D2.3: the printed form with al in (-oo,0) or (1,oo) is the r-form with r = al/(al-1) > 0 *)
Lemma al_neq1 (R : realFieldType) (al : R) : al < 0 \/ 1 < al -> al - 1 != 0.
Proof.
case=> h; first by rewrite lt_eqF // subr_lt0 (lt_trans h ltr01).
by rewrite gt_eqF // subr_gt0.
Qed.
Lemma al_neq0 (R : realFieldType) (al : R) : al < 0 \/ 1 < al -> al != 0.
Proof. by case=> h; [rewrite lt_eqF|rewrite gt_eqF // (lt_trans ltr01)]. Qed.
Lemma D2_3_r_gt0 (R : realFieldType) (al : R) : al < 0 \/ 1 < al -> 0 < al / (al - 1).
Proof.
case=> h; last by rewrite divr_gt0 ?subr_gt0 // (lt_trans ltr01).
by rewrite -mulrNN -invrN mulr_gt0 ?oppr_gt0 // invr_gt0 opprB subr_gt0 (lt_trans h ltr01).
Qed.
Lemma D2_3_forms (R : realFieldType) (al x a b : R) : al < 0 \/ 1 < al -> a <= x -> x <= b -> a < b ->
  f_alpha al x a b = mob (al / (al - 1)) x a b.
Proof.
move=> h ax xb ab; have r0 := D2_3_r_gt0 h; have := mob_den_neq0 r0 ax xb ab.
have e1 := al_neq1 h.
rewrite /f_alpha /mob => hd.
have e : x + (al - 1) * b - al * a = (al - 1) * (al / (al - 1) * (x - a) + (b - x)) by field.
have e2 : x + (al - 1) * b - al * a != 0 by rewrite e mulf_neq0.
have -> : x + (al - 1) * b - al * a = (al - 1) * (al / (al - 1) * (x - a) + (b - x)) by [].
set D := (_ + (b - x)) in hd *.
by field; rewrite hd e1.
Qed.
(* D2.3: the printed form for α < 0 or α > 1 is the r-form with r = α/(α−1), for all x, a, b *)
Theorem D2_3 (R : realFieldType) (al x a b : R) : al < 0 \/ 1 < al ->
  phi_alpha al x a b = phi (al / (al - 1)) x a b.
Proof.
move=> h; rewrite /phi_alpha /phi; case: ifP => // /andP[h1 h2].
by rewrite D2_3_forms // ?(ltW h2) // (le_lt_trans h1 h2).
Qed.
(* the conjugate index 1 - al has ratio 1/r *)
Lemma D2_3_conj (R : realFieldType) (al : R) : al < 0 \/ 1 < al -> (1 - al) / ((1 - al) - 1) = (al / (al - 1))^-1.
Proof.
move=> h; have e0 := al_neq0 h.
have e1 := al_neq1 h.
have -> : 1 - al - 1 = - al by ring.
by field; rewrite e0 e1.
Qed.
(* every r > 0 other than 1 comes from exactly the index r/(r-1); r = 1 is the classical weight *)
Lemma D2_3_inv (R : realFieldType) (r : R) : 0 < r -> r != 1 ->
  (r / (r - 1) < 0 \/ 1 < r / (r - 1)) /\ (r / (r - 1)) / (r / (r - 1) - 1) = r.
Proof.
move=> r0 r1; have e : r - 1 != 0 by rewrite subr_eq0.
split; last first.
  have -> : r / (r - 1) - 1 = (r - 1)^-1 by field.
  by rewrite invrK divfK.
case: (ltgtP r 1) => h; last by rewrite h eqxx in r1.
  by left; rewrite pmulr_rlt0 // invr_lt0 subr_lt0.
by right; rewrite ltr_pdivl_mulr ?subr_gt0 // mul1r ltr_subl_addl ltr_addr ltr01.
Qed.
Lemma phi_classical (R : realFieldType) (x a b : R) : a <= x < b -> phi 1 x a b = (x - a) / (b - a).
Proof. by move=> h; rewrite phi_in // /mob mul1r; congr (_ / _); ring. Qed.

Section P.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Implicit Types x a b c e : R.

(* P2.1.1: 0 ≤ φ ≤ 1 for all x, a, b *)
Theorem P2_1_1 x a b : 0 <= phi r x a b <= 1.
Proof. by have /andP[-> /ltW] := phi_range r_gt0 x a b. Qed.

(* T(x) = c x + e, c > 0 *)
Lemma mob_affine x a b c e : c != 0 -> mob r (c * x + e) (c * a + e) (c * b + e) = mob r x a b.
Proof.
move=> c0; rewrite /mob.
have -> : r * (c * x + e - (c * a + e)) = c * (r * (x - a)) by ring.
have -> : c * b + e - (c * x + e) = c * (b - x) by ring.
by rewrite -mulrDr invfM mulrACA divff // mul1r.
Qed.
(* P2.1.2: φ does not change under T(x) = cx + e, c > 0 *)
Theorem P2_1_2 x a b c e : 0 < c -> phi r (c * x + e) (c * a + e) (c * b + e) = phi r x a b.
Proof.
move=> c0; rewrite /phi mob_affine ?gt_eqF // ler_add2r ltr_add2r.
by rewrite ler_pmul2l // ltr_pmul2l.
Qed.

(* reflection: r-form of 1 - phi_{1-alpha} *)
Lemma mob_mirror x a b : a <= x -> x <= b -> a < b -> mob r (- x) (- b) (- a) = 1 - mob r^-1 x a b.
Proof.
move=> h1 h2 h3; have r1 : r != 0 by rewrite gt_eqF.
have d1 := mob_den_neq0 r_gt0 (x := - x) (a := - b) (b := - a); rewrite !ler_opp2 ltr_opp2 in d1.
have {d1} d1 := d1 h2 h1 h3.
have ri : 0 < r^-1 by rewrite invr_gt0.
have d2 := mob_den_neq0 ri h1 h2 h3.
rewrite /mob; field; rewrite r1 /=.
have -> : x - a + (b - x) * r = r * (r^-1 * (x - a) + (b - x)) by rewrite mulrDr mulVKf // [r * _]mulrC.
by rewrite mulf_neq0.
Qed.
(* P2.1.3 as amended, exactly: the sum is 1 for a < x < b and 0 otherwise, for all real x, a, b; T(x) = e - c x, c > 0 *)
Theorem P2_1_3 x a b c e : 0 < c ->
  phi r (e - c * x) (e - c * b) (e - c * a) + phi r^-1 x a b = if a < x < b then 1 else 0.
Proof.
move=> c0; have cn : c != 0 by rewrite gt_eqF.
have E u : e - c * u = c * (- u) + e by rewrite mulrN addrC.
rewrite !E P2_1_2 //.
have ri : 0 < r^-1 by rewrite invr_gt0.
case: (ltP a x) => ax /=; last first.
  have -> : phi r^-1 x a b = 0.
    by rewrite /phi; case: ifP => // /andP[h _]; have -> : x = a by [apply/eqP; rewrite eq_le ax h]; rewrite mob_a.
  by rewrite /phi ltr_opp2 [a < x]ltNge ax andbF addr0.
case: (ltP x b) => xb; last first.
  rewrite [phi r^-1 _ _ _]/phi ltNge xb andbF addr0 /phi ler_opp2; case: ifP => // /andP[h _].
  by have -> : x = b by [apply/eqP; rewrite eq_le xb h]; rewrite mob_a.
have ab := lt_trans ax xb.
rewrite !phi_in ?ler_opp2 ?ltr_opp2 ?ax ?(ltW ax) ?(ltW xb) ?xb //.
by rewrite mob_mirror ?(ltW ax) ?(ltW xb) // subrK.
Qed.
(* C2.4 as amended *)
Theorem C2_4 a b t1 t2 x : a + b - t2 < x < a + b - t1 ->
  phi r (a + b - x) t1 t2 = 1 - phi r^-1 x (a + b - t2) (a + b - t1).
Proof.
move=> h; have := P2_1_3 x (a + b - t2) (a + b - t1) (a + b) ltr01; rewrite h !mul1r.
have E u : a + b - (a + b - u) = u by ring.
by rewrite !E => <-; rewrite addrK.
Qed.
(* phi.shape: strictly increasing on [a,b); value 0 at a; continuity: P_w in C.v *)
Theorem phi_shape_mono x y a b : a <= x -> x < y -> y < b -> phi r x a b < phi r y a b.
Proof.
move=> ax xy yb; have ay := le_lt_trans ax xy; have xb := lt_trans xy yb.
rewrite !phi_in ?ax ?xb ?(ltW ay) //.
have d1 := mob_den_gt0 r_gt0 ax (ltW xb) (lt_trans ay yb).
have d2 := mob_den_gt0 r_gt0 (ltW ay) (ltW yb) (lt_trans ay yb).
rewrite /mob ltr_pdivr_mulr // mulrAC ltr_pdivl_mulr // -subr_gt0.
have -> : r * (y - a) * (r * (x - a) + (b - x)) - r * (x - a) * (r * (y - a) + (b - y)) = r * ((y - x) * (b - a)) by ring.
by rewrite !mulr_gt0 ?subr_gt0 // (lt_trans ay yb).
Qed.
End P.

(* printed forms: false for every index and for every x outside (a,b) *)
Theorem P2_1_3_printed_false (R : realFieldType) (r x a b c e : R) : 0 < r -> 0 < c -> ~~ (a < x < b) ->
  phi r (e - c * x) (e - c * b) (e - c * a) != 1 - phi r^-1 x a b.
Proof.
move=> r0 c0 h; have := P2_1_3 r0 x a b e c0; rewrite (negbTE h) => E.
rewrite -subr_eq0 opprD opprK addrCA E addr0 oppr_eq0 oner_neq0 //.
Qed.
(* C2.4: for every r there are a, b, t1, t2 and x at which it fails *)
Theorem C2_4_printed_false (R : realFieldType) (r : R) : 0 < r ->
  exists a b t1 t2 x : R, [/\ a < b, a <= t1, t1 < t2, t2 <= b & a <= x <= b /\
    phi r (a + b - x) t1 t2 != 1 - phi r^-1 x (a + b - t2) (a + b - t1)].
Proof.
move=> r0; exists 0, 2%:R, 0, 1, 0; split; rewrite ?ltr0n ?ltr01 ?lexx ?ler1n //.
split; first by rewrite ler0n.
have -> : 0 + 2%:R - 0 = 2%:R :> R by ring.
have -> : 0 + 2%:R - 1 = 1 :> R by ring.
rewrite /phi [2%:R < 1]ltNge ler1n andbF [1 <= 0]leNgt ltr01 /= subr0 eq_sym oner_neq0 //.
Qed.
