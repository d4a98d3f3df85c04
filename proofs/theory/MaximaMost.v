(* k - 1 local maxima, for every degree k >= 2 and every r <> 1, which is as many as there can be. For k = N + 2 the knots are 0, 0, then N
   knots 1 + h T_l close to 1, then 1 + r (1 - h X) and one r h Y further, with a small h > 0. At 1 + h z, between the knots j and j+1 of
   the cluster, 8 G_0^k is a constant minus h^2 F_j(z) up to the third order in h, with rho = 1/r and
     F_j = m^2 + mu^2 + 2 Q + Y (m + (1 - rho) z/2),  m = mu - X - (1 + rho) z,
   where mu is the sum of the distances T_l - z, those to the right times rho, and Q that of their squares. F_j is quadratic, and at a knot
   its slope drops by (1 - rho)(2 m + 2 mu + Y). The T_l are chosen so that it drops from one half of this to minus one half. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Values Tower ClusterRace ClusterExpansion Theorem3 MaximaBound MaximaSigns.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- the sums over the cluster, j of its knots to the left ---- *)
Section Sums.
Variable R : realFieldType.
Variable rho : R.
Variable N : nat.
Variable T : nat -> R.
Definition co j l : R := if (l < j)%N then 1 else rho.
Definition sg j := \sum_(l < N) co j l.
Definition sq j := \sum_(l < N) co j l ^+ 2.
Definition mu j z := \sum_(l < N) co j l * (T l - z).
Definition ka j z := \sum_(l < N) co j l ^+ 2 * (T l - z).
Definition Q j z := \sum_(l < N) (co j l * (T l - z)) ^+ 2.
Lemma mu_shift j z e : mu j (z + e) = mu j z - sg j * e.
Proof. by rewrite /mu /sg mulr_suml -sumrB; apply: eq_bigr => l _; ring. Qed.
Lemma ka_shift j z e : ka j (z + e) = ka j z - sq j * e.
Proof. by rewrite /ka /sq mulr_suml -sumrB; apply: eq_bigr => l _; ring. Qed.
Lemma Q_shift j z e : Q j (z + e) = Q j z - 2%:R * ka j z * e + sq j * e ^+ 2.
Proof.
rewrite /Q /ka /sq mulr_sumr !mulr_suml -sumrB -big_split; apply: eq_bigr => l _; rewrite /=; ring.
Qed.
(* at a knot of the cluster it does not matter on which side it is *)
Lemma co_S j l : l <> j -> co j.+1 l = co j l.
Proof. by move=> n; rewrite /co ltnS leq_eqVlt; case: eqP. Qed.
Lemma mu_S j : mu j.+1 (T j) = mu j (T j).
Proof.
apply: eq_bigr => l _; case: (eqVneq (l : nat) j) => [->|/eqP n]; by rewrite ?subrr ?mulr0 // co_S.
Qed.
Lemma ka_S j : ka j.+1 (T j) = ka j (T j).
Proof.
apply: eq_bigr => l _; case: (eqVneq (l : nat) j) => [->|/eqP n]; by rewrite ?subrr ?mulr0 // co_S.
Qed.
Lemma Q_S j : Q j.+1 (T j) = Q j (T j).
Proof.
apply: eq_bigr => l _; case: (eqVneq (l : nat) j) => [->|/eqP n]; by rewrite ?subrr ?mulr0 // co_S.
Qed.
Lemma sg_S j : (j < N)%N -> sg j.+1 = sg j + (1 - rho).
Proof.
move=> jN; rewrite /sg (bigD1 (Ordinal jN)) //= [in RHS](bigD1 (Ordinal jN)) //=.
rewrite (eq_bigr (fun l : 'I_N => co j l)); last by move=> l /eqP n; apply: co_S => e; apply: n; apply: val_inj.
by move: (\sum_(_ < _ | _) _) => z; rewrite /co ltnSn ltnn; ring.
Qed.
(* F_j, minus its derivative, and its second derivative *)
Variables X Y : R.
Definition mm j z := mu j z - X - (1 + rho) * z.
Definition FF j z := mm j z ^+ 2 + mu j z ^+ 2 + 2%:R * Q j z + Y * (mm j z + (1 - rho) * z / 2%:R).
Definition gg j z := 2%:R * mm j z + 2%:R * mu j z + Y.
Definition HH j z := sg j * gg j z + (1 + rho) * (2%:R * mm j z + Y) + 4%:R * ka j z - Y * (1 - rho) / 2%:R.
Definition AA j := 4%:R * sg j ^+ 2 + 4%:R * sg j * (1 + rho) + 2%:R * (1 + rho) ^+ 2 + 4%:R * sq j.
Definition BB j := 2%:R * (2%:R * sg j + 1 + rho).
Lemma FF_shift j z e : FF j (z + e) = FF j z - e * (HH j z - e * AA j / 2%:R).
Proof.
have n2 : 2%:R != 0 :> R by rewrite pnatr_eq0.
by rewrite /FF /HH /AA /gg /mm mu_shift Q_shift; field; rewrite ?n2.
Qed.
Lemma gg_shift j z e : gg j (z + e) = gg j z - BB j * e.
Proof. by rewrite /gg /mm /BB mu_shift; ring. Qed.
Lemma HH_shift j z e : HH j (z + e) = HH j z - AA j * e.
Proof. by rewrite /HH /AA gg_shift /BB ka_shift /mm mu_shift; ring. Qed.
Lemma FF_S j : FF j.+1 (T j) = FF j (T j).
Proof. by rewrite /FF /mm mu_S Q_S. Qed.
Lemma gg_S j : gg j.+1 (T j) = gg j (T j).
Proof. by rewrite /gg /mm mu_S. Qed.
Lemma HH_S j : (j < N)%N -> HH j.+1 (T j) = HH j (T j) + (1 - rho) * gg j (T j).
Proof. by move=> jN; rewrite /HH gg_S /mm mu_S ka_S sg_S //; ring. Qed.
Lemma HH_0 j z : HH j z = sg j * gg j z + (1 + rho) * (Y - 2%:R * X - 2%:R * (1 + rho) * z + 2%:R * mu j z) + 4%:R * ka j z - Y * (1 - rho) / 2%:R.
Proof. by rewrite /HH /mm; congr (_ + _ * _ + _ - _); ring. Qed.
Lemma gg_0 j z : gg j z = Y - 2%:R * X - 2%:R * (1 + rho) * z + 4%:R * mu j z.
Proof. by rewrite /gg /mm; ring. Qed.
Hypothesis rho0 : 0 < rho.
Lemma co_gt0 j l : 0 < co j l. Proof. by rewrite /co; case: ifP => _; rewrite ?ltr01. Qed.
Lemma sg_ge0 j : 0 <= sg j. Proof. by apply: sumr_ge0 => l _; rewrite ltW // co_gt0. Qed.
Lemma sq_ge0 j : 0 <= sq j. Proof. by apply: sumr_ge0 => l _; exact: sqr_ge0. Qed.
(* A is larger than what turns up below *)
Lemma AA_large j : `|(1 - rho) * BB j / 2%:R| < AA j.
Proof.
have n2 : 2%:R != 0 :> R by rewrite pnatr_eq0.
have s0 := sg_ge0 j; have q0 := sq_ge0 j; have o0 : 0 <= 1 + rho by rewrite addr_ge0 ?ler01 ?ltW.
have -> : (1 - rho) * BB j / 2%:R = (1 - rho) * (2%:R * sg j + 1 + rho) by rewrite /BB; field; rewrite ?n2.
have b0 : 0 <= 2%:R * sg j + 1 + rho by rewrite -addrA addr_ge0 // mulr_ge0 ?ler0n.
rewrite normrM (ger0_norm b0); apply: (@le_lt_trans _ _ ((1 + rho) * (2%:R * sg j + 1 + rho))).
  apply: ler_wpmul2r => //; rewrite (le_trans (ler_norm_sub _ _)) // normr1 (gtr0_norm rho0) //.
rewrite -subr_gt0.
have -> : AA j - (1 + rho) * (2%:R * sg j + 1 + rho) = (1 + rho) ^+ 2 + (4%:R * sg j ^+ 2 + 2%:R * sg j * (1 + rho) + 4%:R * sq j).
  by rewrite /AA; ring.
apply: ltr_paddr; last by rewrite exprn_gt0 // addr_gt0 ?ltr01.
by rewrite !addr_ge0 // ?mulr_ge0 ?ler0n ?sqr_ge0.
Qed.
End Sums.

(* ---- the choice of T, X and Y ---- *)
Section Choice.
Variable R : realFieldType.
Variable rho : R.
Hypothesis rho0 : 0 < rho.
Hypothesis rho1 : rho != 1.
Variable N : nat.
Hypothesis N0 : (0 < N)%N.
Local Notation A := (AA rho N). Local Notation B := (BB rho N).
Definition gap j (g : R) := (1 - rho) * g / (A j + (1 - rho) * B j / 2%:R).
Fixpoint state (l : nat) : R * R :=
  if l is l'.+1 then let st := state l' in let d := gap l st.2 in (st.1 + d, st.2 - B l * d) else (0, (1 - rho)^-1).
Definition T l := (state l).1.
Definition gs l := (state l).2.
Lemma T_S l : T l.+1 = T l + gap l.+1 (gs l). Proof. by []. Qed.
Lemma gs_S l : gs l.+1 = gs l - B l.+1 * gap l.+1 (gs l). Proof. by []. Qed.
Let n1 : 1 - rho != 0. Proof. by rewrite subr_eq0 eq_sym. Qed.
Let n2 : 2%:R != 0 :> R. Proof. by rewrite pnatr_eq0. Qed.
Lemma den_gt0 j : 0 < A j + (1 - rho) * B j / 2%:R /\ 0 < A j - (1 - rho) * B j / 2%:R.
Proof.
have := AA_large N rho0 j; rewrite ltr_norml => /andP[h1 h2].
by rewrite subr_gt0 h2 -[X in 0 < X + _]opprK addrC subr_gt0.
Qed.
(* the drops of the slopes are positive *)
Lemma gs_gt0 l : 0 < (1 - rho) * gs l.
Proof.
elim: l => [|l IH]; first by rewrite /gs /= divff // ltr01.
have [d1 d2] := den_gt0 l.+1; rewrite gs_S /gap.
have -> : (1 - rho) * (gs l - B l.+1 * ((1 - rho) * gs l / (A l.+1 + (1 - rho) * B l.+1 / 2%:R))) =
  (1 - rho) * gs l * ((A l.+1 - (1 - rho) * B l.+1 / 2%:R) / (A l.+1 + (1 - rho) * B l.+1 / 2%:R)).
  have := gt_eqF d1; move: (A l.+1) (B l.+1) => a b /negbT d.
  have d' : a * 2%:R + (1 - rho) * b != 0.
    by have -> : a * 2%:R + (1 - rho) * b = (a + (1 - rho) * b / 2%:R) * 2%:R by [field; rewrite ?n2]; rewrite mulf_neq0.
  by field; rewrite ?n2 ?d'.
by rewrite mulr_gt0 ?divr_gt0.
Qed.
Lemma T_lt l : T l < T l.+1.
Proof. by rewrite T_S ltr_addl divr_gt0 ?gs_gt0 //; case: (den_gt0 l.+1). Qed.
Lemma T_le l l' : (l <= l')%N -> T l <= T l'.
Proof. by apply: t_le => i; rewrite ltW // T_lt. Qed.
Definition M0 := mu rho N T 0 (T 0%N).
Definition K0 := ka rho N T 0 (T 0%N).
Definition Y : R := 2%:R / (1 - rho) * ((sg rho N 0 + 1 + rho) * gs 0 + (1 - rho) * gs 0 / 2%:R - 2%:R * (1 + rho) * M0 + 4%:R * K0).
Definition X : R := (4%:R * M0 + Y - gs 0) / 2%:R.
Local Notation F := (FF rho N T X Y). Local Notation g := (gg rho N T X Y). Local Notation H := (HH rho N T X Y).
(* the slopes at the knots of the cluster *)
Lemma slopes l : (l < N)%N -> [/\ g l (T l) = gs l, H l (T l) = - ((1 - rho) * gs l / 2%:R) & H l.+1 (T l) = (1 - rho) * gs l / 2%:R].
Proof.
elim: l => [|l IH] lN.
  have e0 : T 0%N = 0 by [].
  have e1 : g 0 (T 0%N) = gs 0 by rewrite gg_0 /X -/M0 e0; field; rewrite ?n2.
  have e2 : H 0 (T 0%N) = - ((1 - rho) * gs 0 / 2%:R).
    rewrite HH_0 e1 -/M0 -/K0 e0 /X; have : Y * (1 - rho) / 2%:R = (sg rho N 0 + 1 + rho) * gs 0 + (1 - rho) * gs 0 / 2%:R - 2%:R * (1 + rho) * M0 + 4%:R * K0.
      by rewrite /Y; field; rewrite ?n1 ?n2.
    by move=> ->; field; rewrite ?n2.
  by split=> //; rewrite HH_S // e1 e2; field; rewrite ?n2.
have [e1 e2 e3] := IH (ltnW lN); have [d1 _] := den_gt0 l.+1.
have e4 : g l.+1 (T l.+1) = gs l.+1 by rewrite T_S gg_shift gg_S e1.
have e5 : H l.+1 (T l.+1) = - ((1 - rho) * gs l.+1 / 2%:R).
  rewrite T_S HH_shift e3 gs_S.
  have : gap l.+1 (gs l) * (A l.+1 + (1 - rho) * B l.+1 / 2%:R) = (1 - rho) * gs l by rewrite divfK // gt_eqF.
  move: (gap _ _) (A _) (B _) => d a b e; apply/eqP; rewrite -subr_eq0; apply/eqP.
  have -> : (1 - rho) * gs l / 2%:R - a * d - - ((1 - rho) * (gs l - b * d) / 2%:R) = (1 - rho) * gs l - d * (a + (1 - rho) * b / 2%:R).
    by field; rewrite ?n2.
  by rewrite e subrr.
by split=> //; rewrite HH_S // e4 e5; field; rewrite ?n2.
Qed.
(* the last two knots are in order *)
Lemma Y_gt0 : 0 < Y.
Proof.
have lN : (N.-1 < N)%N by rewrite prednK.
have [a1 a2 _] := slopes N0; have [b1 _ b2] := slopes lN; rewrite prednK // in b2.
have b1' : g N (T N.-1) = gs N.-1 by rewrite -b1 -{1}[N in g N]prednK // gg_S.
have c0 := gs_gt0 0; have c1 := gs_gt0 N.-1.
have sgn j (z : R) (hz : 0 <= z) : 0 <= sg rho N j * z by rewrite mulr_ge0 ?sg_ge0.
have pos f : (forall l, (l < N)%N -> 0 <= f l) -> 0 <= \sum_(l < N) f l :> R by move=> h; apply: sumr_ge0 => l _; apply: h.
have m0 : 0 <= mu rho N T 0 (T 0%N) by apply: (pos (fun l => co rho 0 l * (T l - T 0%N))) => l _; rewrite mulr_ge0 ?(ltW (co_gt0 rho0 _ _)) // subr_ge0 T_le.
have k0 : 0 <= ka rho N T 0 (T 0%N) by apply: (pos (fun l => co rho 0 l ^+ 2 * (T l - T 0%N))) => l _; rewrite mulr_ge0 ?sqr_ge0 // subr_ge0 T_le.
have m1 : 0 <= - mu rho N T N (T N.-1).
  rewrite -sumrN; apply: (pos (fun l => - (co rho N l * (T l - T N.-1)))) => l h; rewrite -mulrN opprB mulr_ge0 ?(ltW (co_gt0 rho0 _ _)) // subr_ge0 T_le //.
  by rewrite -ltnS prednK.
have k1 : 0 <= - ka rho N T N (T N.-1).
  rewrite -sumrN; apply: (pos (fun l => - (co rho N l ^+ 2 * (T l - T N.-1)))) => l h; rewrite -mulrN opprB mulr_ge0 ?sqr_ge0 // subr_ge0 T_le //.
  by rewrite -ltnS prednK.
have dT : 0 <= T N.-1 - T 0%N by rewrite subr_ge0 T_le.
have o0 : 0 < 1 + rho by rewrite addr_gt0 ?ltr01.
have half (z : R) : 0 < z -> 0 < z / 2%:R by move=> h; rewrite divr_gt0 ?ltr0n.
rewrite HH_0 a1 in a2; rewrite HH_0 b1' in b2; rewrite gg_0 in a1; rewrite gg_0 in b1'.
move: a1 a2 b1' b2 m0 k0 m1 k1 dT; move: (mu _ _ _ _ _) (ka _ _ _ _ _) (mu _ _ _ _ _) (ka _ _ _ _ _) => {b1} m' k' m k a1 a2 b1 b2 m0 k0 m1 k1 dT.
set s0 := Y - 2%:R * X - _ in a1 a2; set s1 := Y - 2%:R * X - _ in b1 b2.
have es : s0 = s1 + 2%:R * ((1 + rho) * (T N.-1 - T 0%N)) by rewrite /s0 /s1; ring.
have et : 0 <= 2%:R * ((1 + rho) * (T N.-1 - T 0%N)) by rewrite mulr_ge0 ?ler0n // mulr_ge0 // ltW.
clearbody s0 s1; move: (T N.-1 - T 0%N) dT es et => dT dT0 es et.
case: (ltgtP rho 1) => hr; last by case/eqP: rho1.
  have r1 : 0 < 1 - rho by rewrite subr_gt0.
  have g0 : 0 <= gs 0 by rewrite ltW // -(pmulr_rgt0 _ r1).
  have g1 : 0 <= gs N.-1 by rewrite ltW // -(pmulr_rgt0 _ r1).
  have s1p : 0 <= s1 by have -> : s1 = gs N.-1 + 4%:R * - m' by [rewrite -b1; ring]; rewrite addr_ge0 // mulr_ge0 ?ler0n.
  have s0p : 0 <= s0 by rewrite es addr_ge0.
  rewrite -(pmulr_rgt0 _ r1).
  have -> : (1 - rho) * Y = 2%:R * ((1 - rho) * gs 0 / 2%:R + (sg rho N 0 * gs 0 + (1 + rho) * (s0 + 2%:R * m) + 4%:R * k)).
    move: a2 => /eqP; rewrite subr_eq => /eqP ->; field; rewrite ?n2 //.
  rewrite mulr_gt0 ?ltr0n // ltr_paddr ?half // !addr_ge0 ?sgn // mulr_ge0 ?ler0n ?(ltW o0) // addr_ge0 // mulr_ge0 ?ler0n //.
have r1 : 0 < rho - 1 by rewrite subr_gt0.
have neg l : 0 <= - gs l by rewrite ltW // -(pmulr_rgt0 _ r1) mulrN -mulNr opprB gs_gt0.
have s0n : 0 <= - s0 by have -> : - s0 = - gs 0 + 4%:R * m by [rewrite -a1; ring]; rewrite addr_ge0 // mulr_ge0 ?ler0n.
have s1n : 0 <= - s1 by have -> : - s1 = - s0 + 2%:R * ((1 + rho) * dT) by [rewrite es; ring]; rewrite addr_ge0.
rewrite -(pmulr_rgt0 _ r1).
have -> : (rho - 1) * Y = 2%:R * ((1 - rho) * gs N.-1 / 2%:R + (sg rho N N * - gs N.-1 + (1 + rho) * (- s1 + 2%:R * - m') + 4%:R * - k')).
  move: b2 => /eqP; rewrite subr_eq => /eqP e; have -> : sg rho N N * - gs N.-1 = - (sg rho N N * gs N.-1) by ring.
  have -> : sg rho N N * gs N.-1 = (1 - rho) * gs N.-1 / 2%:R + Y * (1 - rho) / 2%:R - 4%:R * k' - (1 + rho) * (s1 + 2%:R * m') by rewrite -e; ring.
  by field; rewrite ?n2.
by rewrite mulr_gt0 ?ltr0n // ltr_paddr ?half // !addr_ge0 ?sgn // mulr_ge0 ?ler0n ?(ltW o0) // addr_ge0 // mulr_ge0 ?ler0n.
Qed.
(* F has a peak at each knot of the cluster: it is smaller on both sides near by *)
Lemma peaks l : (l < N)%N -> exists e, [/\ 0 < e, l = 0%N \/ T l.-1 < T l - e, T l + e < T l.+1, F l (T l - e) < F l (T l) & F l.+1 (T l + e) < F l.+1 (T l)].
Proof.
move=> lN; have [_ h1 h2] := slopes lN; have c := gs_gt0 l; set c' := (1 - rho) * gs l in h1 h2 c.
have c2 : 0 < c' / 2%:R by rewrite divr_gt0 ?ltr0n.
have S1 := soon_lin (- (A l / 2%:R)) c2. have S2 := soon_lin (- (A l.+1 / 2%:R)) c2.
have d1 : 0 < T l.+1 - T l by rewrite subr_gt0 T_lt.
have S3 : soon (fun e => 0 < (T l.+1 - T l) + -1 * e) by apply: soon_lin.
have [d2 d0 hd] : exists2 d, 0 < d & l = 0%N \/ d = T l - T l.-1.
  by case: (l) => [|l']; [exists 1; [exact: ltr01|left]|exists (T l'.+1 - T l'); [rewrite subr_gt0 T_lt|right]].
have S5 := soon_lin (-1) d0.
have [d dp Hd] := soon_and (soon_and S1 S2) (soon_and S3 S5).
have dd : 0 < d / 2%:R < d by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
have [[p1 p2] [p3 p4]] := Hd _ dd; case/andP: dd => e0 _; set e := d / 2%:R in e0 p1 p2 p3 p4; exists e; split=> //.
- case: hd => [->|hd]; [by left|right]; rewrite -subr_gt0; move: p4; rewrite hd; congr (0 < _); ring.
- by rewrite -subr_gt0; move: p3; congr (0 < _); ring.
- rewrite FF_shift h1; have -> : - e * (- (c' / 2%:R) - - e * A l / 2%:R) = e * (c' / 2%:R + - (A l / 2%:R) * e) by field; rewrite ?n2.
  by rewrite ltr_subl_addr ltr_addl mulr_gt0.
rewrite FF_shift h2; have -> : e * (c' / 2%:R - e * A l.+1 / 2%:R) = e * (c' / 2%:R + - (A l.+1 / 2%:R) * e) by field; rewrite ?n2.
by rewrite ltr_subl_addr ltr_addl mulr_gt0.
Qed.
End Choice.

(* ---- the knots, and G_0^k on them ---- *)
Section Knots.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Local Notation rho := (r^-1).
Variable N : nat.
Hypothesis N0 : (0 < N)%N.
Variable T : nat -> R.
Hypothesis T_lt : forall l, T l < T l.+1.
Variables X Y : R.
Hypothesis Y0 : 0 < Y.
Definition last_knot (h : R) := 1 + r * (1 - h * X).
Definition knots (h : R) (i : nat) : R :=
  if (i < 2)%N then 0 else if (i < N.+2)%N then 1 + h * T (i - 2) else if (i < N.+3)%N then last_knot h else last_knot h + r * (h * Y).
Lemma knots01 h i : (i < 2)%N -> knots h i = 0. Proof. by rewrite /knots => ->. Qed.
Lemma knots_in h l : (l < N)%N -> knots h l.+2 = 1 + h * T l.
Proof. by move=> lN; rewrite /knots !ltnS ltn0 lN subSS subSS subn0. Qed.
Lemma knots_last h : knots h N.+2 = last_knot h.
Proof. by rewrite /knots !ltnS ltn0 ltnn leqnn. Qed.
Lemma knots_end h i : (N.+3 <= i)%N -> knots h i = last_knot h + r * (h * Y).
Proof.
move=> hi; rewrite /knots; case: ifP => [h1|_]; first by move: hi h1; clear; lia.
case: ifP => [h1|_]; first by move: hi h1; clear; lia.
by case: ifP => // h1; move: hi h1; clear; lia.
Qed.
Let Tle l l' : (l <= l')%N -> T l <= T l'.
Proof. by apply: t_le => i; rewrite ltW // T_lt. Qed.
(* a point 1 + h z is before the last knots *)
Lemma before_end (z : R) : soon (fun h => 1 + h * z < last_knot h).
Proof.
apply: soon_imp (soon_lin (- (r * X) - z) r_gt0) => h h0; rewrite /last_knot -[1 + h * z < _]subr_gt0; congr (0 < _); ring.
Qed.
Lemma after_start (z : R) : soon (fun h => 0 < 1 + h * z).
Proof. by apply: soon_imp (soon_lin z ltr01) => h h0; rewrite mulrC. Qed.
Lemma knots_ordered : soon (fun h => forall i, knots h i <= knots h i.+1).
Proof.
apply: soon_imp (soon_and (after_start (T 0%N)) (before_end (T N.-1))) => h h0 [s0 s1] i.
case: (ltnP i.+1 2) => h1; first by rewrite !knots01 // ltnW.
case: i h1 => [|[|l]] // _; first by rewrite knots01 // knots_in // ltW.
case: (ltnP l.+1 N) => h2; first by rewrite !knots_in ?(ltnW h2) // ler_add2l ler_pmul2l // Tle.
have e0 : 0 <= r * (h * Y) by rewrite mulr_ge0 ?mulr_ge0 // ltW.
case: (ltnP l N) => h3.
  have -> : l = N.-1 by move: h2 h3; clear; lia.
  by rewrite knots_in ?prednK // knots_last ltW.
by case: (ltngtP l N) h3 => // [h3|->] _; rewrite ?knots_last !knots_end // ?ler_addl // ltnW.
Qed.
(* z lies between the knots j and j+1 of the cluster *)
Definition between j z := [/\ (j <= N)%N, forall l, (l < j)%N -> T l <= z & forall l, (j <= l)%N -> (l < N)%N -> z < T l].
Lemma place_soon j z : between j z -> soon (fun h => knots h j.+1 <= 1 + h * z < knots h j.+2).
Proof.
move=> [jN left right]; apply: soon_imp (soon_and (after_start z) (before_end z)) => h h0 [s0 s1]; apply/andP; split.
  case: j jN left {right} => [|l] jN left; first by rewrite knots01 // ltW.
  by rewrite knots_in // ler_add2l ler_pmul2l // left.
case: (ltnP j N) => hj; first by rewrite knots_in // ltr_add2l ltr_pmul2l // right.
by have -> : j = N by [apply/eqP; rewrite eqn_leq jN]; rewrite knots_last.
Qed.
Definition al j z := [seq z - T l | l <- iota 0 j].
Definition be j z := [seq (T l - z) / r | l <- rev (iota j (N - j))].
Lemma left_knots j z h : (j <= N)%N -> left_of (knots h) j.+1 (1 + h * z) 0 = [:: 1 + h * z, 1 + h * z & scaled (al j z) h].
Proof.
move=> jN; rewrite /left_of subn0 [iota 0 _]/= /= !knots01 // subr0; congr [:: _, _ & _].
rewrite (iotaDl 2 0) -map_comp /scaled -map_comp; apply/eq_in_map => l; rewrite mem_iota add0n => /andP[_ lj] /=.
rewrite add2n knots_in ?(leq_trans lj) //; ring.
Qed.
Lemma right_knots j z h e : between j z -> (e <= 1)%N -> right_of r (knots h) j.+1 (1 + h * z) (N + 2 + e) =
  [seq (last_knot h + (if i == 0%N then 0 else r * (h * Y)) - (1 + h * z)) / r | i <- rev (iota 0 e.+1)] ++ scaled (be j z) h.
Proof.
move=> [jN _ _] e1; rewrite /right_of; have -> : (N + 2 + e - j.+1 = N - j + e.+1)%N by move: jN; clear; lia.
rewrite iotaD rev_cat map_cat; congr (_ ++ _).
  have -> : (j.+2 + (N - j) = N.+2 + 0)%N by move: jN; clear; lia.
  rewrite iotaDl -!map_rev -map_comp; apply/eq_in_map => i; rewrite mem_rev mem_iota /= add0n => ie.
  case: eqP => [->|n]; first by rewrite addn0 knots_last addr0.
  by rewrite knots_end //; move: n; clear; lia.
have -> : j.+2 = (2 + j)%N by []. 
rewrite iotaDl -!map_rev /be /scaled -!map_comp; apply/eq_in_map => l; rewrite mem_rev mem_iota => /andP[h1 h2] /=.
rewrite add2n knots_in; last by move: jN h2; clear; lia.
by rewrite mulrA; congr (_ / r); ring.
Qed.
Lemma sides_cluster j z : between j z -> sides (al j z) (be j z).
Proof.
move=> [jN left right].
have a0 a : a \in al j z -> 0 <= a by move=> /mapP[l]; rewrite mem_iota add0n => /andP[_ lj] ->; rewrite subr_ge0 left.
have b0 b : b \in be j z -> 0 < b.
  move=> /mapP[l]; rewrite mem_rev mem_iota => /andP[h1 h2] ->; rewrite divr_gt0 // subr_gt0 right //.
  by move: jN h2; clear; lia.
apply/andP; split; first by apply/andP; split; apply/allP => x; [apply: a0|move=> /b0 /ltW].
by apply/allP => a /a0 h1; apply/allP => b /b0 h2; rewrite ltr_paddl.
Qed.
(* the sums of the lengths in both orders *)
Lemma cluster_sums j z : (j <= N)%N -> \sum_(b <- be j z) b - \sum_(a <- al j z) a = mu rho N T j z /\
  \sum_(b <- be j z) b ^+ 2 + \sum_(a <- al j z) a ^+ 2 = Q rho N T j z.
Proof.
move=> jN; have pe : perm_eq (be j z) [seq (T l - z) / r | l <- iota j (N - j)].
  by rewrite /be perm_map // perm_rev.
have sp (F : nat -> R) : \sum_(l < N) F l = \sum_(l <- iota 0 j) F l + \sum_(l <- iota j (N - j)) F l.
  by rewrite -(big_mkord xpredT) /index_iota subn0 -big_cat -[in RHS]iotaD subnKC.
rewrite /mu /Q (sp (fun l => co rho j l * (T l - z))) (sp (fun l => (co rho j l * (T l - z)) ^+ 2)).
rewrite !(perm_big _ pe) /= !big_map; split.
  rewrite addrC -sumrN; congr (_ + _); apply: eq_big_seq => l; rewrite mem_iota => /andP[h1 h2]; rewrite /co.
    by rewrite add0n in h2; rewrite h2 mul1r opprB.
  by rewrite ltnNge h1 mulrC.
rewrite addrC; congr (_ + _); apply: eq_big_seq => l; rewrite mem_iota => /andP[h1 h2]; rewrite /co.
  by rewrite add0n in h2; rewrite h2 mul1r -sqrrN opprB.
by rewrite ltnNge h1 [rho * _]mulrC.
Qed.
Local Notation f h := (G (wt r (knots h)) (knots h) N.+2 0).
Local Notation F := (FF rho N T X Y).
Definition const : R := Y ^+ 2 / 2%:R - Y * X / 2%:R.
(* G_0^k at 1 + h z, up to the third order in h *)
Theorem G_near j z : between j z -> O 3 (fun h => f h (1 + h * z) - (2%:R^-1 + Y / 8%:R * h - (F j z + const) / 8%:R * h ^+ 2)).
Proof.
move=> hb; have [jN _ _] := hb; have n2 : 2%:R != 0 :> R by rewrite pnatr_eq0. have n8 : 8%:R != 0 :> R by rewrite pnatr_eq0.
have rn : r != 0 by rewrite gt_eqF.
have H := chances_difference z (- X - rho * z) (- X - rho * z + Y) (sides_cluster hb).
apply: O_ext H; apply: soon_imp (soon_and knots_ordered (place_soon hb)) => h h0 [mono hx].
have [e1 e2] := cluster_sums z jN.
rewrite (G_chances r_gt0 mono hx) left_knots //.
have -> : left_of (knots h) j.+1 (1 + h * z) 1 = 1 + h * z :: scaled (al j z) h.
  by have := left_knots z h jN; rewrite /left_of subn0 subSS subn0 /= => -[_ -> ->].
have -> : N.+2 = (N + 2 + 0)%N by rewrite addn0 addn2. have -> : (N + 2 + 0).+1 = (N + 2 + 1)%N by rewrite addn0 addn1.
rewrite !right_knots // e1 e2 /lin /=.
have -> : (last_knot h + 0 - (1 + h * z)) / r = 1 + (- X - rho * z) * h by rewrite /last_knot; field; rewrite ?rn.
have -> : (last_knot h + r * (h * Y) - (1 + h * z)) / r = 1 + (- X - rho * z + Y) * h by rewrite /last_knot; field; rewrite ?rn.
rewrite [z * h]mulrC; congr (_ - _ - _); rewrite /const /FF /mm.
by move: (mu _ _ _ _ _) (Q _ _ _ _ _) => m q; field; rewrite ?n2 ?n8 ?rn.
Qed.
(* the smaller F, the larger G_0^k *)
Lemma G_compare j z j' z' : between j z -> between j' z' -> F j' z' < F j z -> soon (fun h => f h (1 + h * z) < f h (1 + h * z')).
Proof.
move=> b1 b2 lt; have n8 : 8%:R != 0 :> R by rewrite pnatr_eq0. have n2 : 2%:R != 0 :> R by rewrite pnatr_eq0.
have c0 : 0 < (F j z - F j' z') / 8%:R by rewrite divr_gt0 ?subr_gt0 ?ltr0n.
have H : O 3 (fun h => f h (1 + h * z') - f h (1 + h * z) - (F j z - F j' z') / 8%:R * h ^+ 2).
  apply: O_ext (O_add (G_near b2) (O_opp (G_near b1))); exists 1; [exact: ltr01|move=> h _].
  by move: (f h _) (f h _) (F _ _) (F _ _) => a b c d; field; rewrite ?n2 ?n8.
by apply: soon_imp (O_pos c0 H) => h _; rewrite subr_gt0.
Qed.
End Knots.

(* ---- from lower values at k - 2 knots to k - 1 maxima ---- *)
Section Valleys.
Variable R : rcfType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable N : nat.
Local Notation k := N.+2.
Local Notation f := (value r t k.+1 k 0).
Local Notation M := (local_max f (t 0%N) (t k.+1)).
Let tle := t_le t_mono.
Hypothesis N0 : (0 < N)%N.
Hypothesis spans : forall l, (l <= N)%N -> t l.+1 < t l.+2.
Hypothesis low_left : forall l, (l < N)%N -> exists2 z, t l.+1 <= z <= t l.+2 & f (t l.+2) < f z.
Hypothesis low_right : forall l, (l < N)%N -> exists2 z, t l.+2 <= z <= t l.+3 & f (t l.+2) < f z.
Let U : t 0%N < t k.+1.
Proof. by apply: (@le_lt_trans _ _ (t 1%N)) => //; apply: (lt_le_trans (spans (leq0n N))); apply: tle. Qed.
(* N knots at which the function is lower than somewhere on both spans beside make N + 1 local maxima *)
Theorem valleys_maxima : exists xs : seq R, [/\ sorted <%R xs, size xs = N.+1 & forall x, x \in xs -> M x].
Proof.
have add xs x : sorted <%R xs -> (forall y, y \in xs -> y < x) -> sorted <%R (rcons xs x).
  move=> s h; rewrite (sorted_pairwise lt_trans) pairwise_rcons -(sorted_pairwise lt_trans) s andbT.
  by apply/allP => y; apply: h.
have pk := @peak_values R r r_gt0 t t_mono k isT U.
have step n : (0 < n <= N)%N -> exists xs : seq R, [/\ sorted <%R xs, size xs = n & forall x, x \in xs -> M x /\ x < t n.+1].
  elim: n => // n IH; rewrite ltnS => /andP[_ nN]; case: (posnP n) => [n0|n0].
    have [z /andP[z0 z1] lt] := low_left nN; rewrite n0 in z0 z1 lt nN *.
    have t01 : t 0%N <= t 1%N by []. have t02 : t 0%N < t 2%N by apply: (le_lt_trans t01); apply: (spans (leq0n N)).
    have [||x [h1 _ _ h2]] := pk 0%N 2%N isT t02; [by left|by right; exists z => //; rewrite z1 (le_trans t01)|].
    by exists [:: x]; split=> // y; rewrite inE => /eqP ->; case: h2.
  have [|xs [s1 s2 s3]] := IH; first by rewrite n0 ltnW.
  have [m en] : exists m, n = m.+1 by exists n.-1; rewrite prednK.
  have mN : (m < N)%N by rewrite -en ltnW.
  have ab : (n.+1 <= n.+2 <= k.+1)%N by move: nN; clear; lia.
  have [||x [h1 _ [//|h2] h3]] := pk n.+1 n.+2 ab (spans (ltnW nN)).
  - by right; rewrite en; exact: low_right.
  - by right; exact: low_left.
  exists (rcons xs x); split; first by apply: add => // y /s3[_ h]; exact: lt_trans h2.
    by rewrite size_rcons s2.
  move=> y; rewrite mem_rcons inE => /orP[/eqP ->|/s3[hy1 hy2]]; last by split=> //; apply: lt_le_trans hy2 _; apply: tle.
  by split=> //; case: h3 => // -[e]; move: nN; rewrite e; clear; lia.
have [|xs [s1 s2 s3]] := step N; first by rewrite N0 leqnn.
have [m en] : exists m, N = m.+1 by exists N.-1; rewrite prednK.
have mN : (m < N)%N by rewrite en.
have ab : (N.+1 <= k.+1 <= k.+1)%N by clear; lia.
have lt : t N.+1 < t k.+1 by apply: (lt_le_trans (spans (leqnn N))); apply: tle.
have [||x [h1 _ [//|h2] _]] := pk N.+1 k.+1 ab lt; [|by left|].
  have [z /andP[z0 z1] hz] := low_right mN; right; rewrite -en in z0 z1 hz; exists z => //; rewrite z0 (le_trans z1) //; exact: tle.
exists (rcons xs x); split; first by apply: add => // y /s3[_ h]; exact: lt_trans h2.
  by rewrite size_rcons s2.
by move=> y; rewrite mem_rcons inE => /orP[/eqP ->|/s3[]].
Qed.
(* inside of a span the function is above the lower one of two values around that differ, ends included *)
Lemma span_above s a b d : (s <= k)%N -> t s <= a -> a < b -> b < d -> d <= t s.+1 -> f a != f d -> Num.min (f a) (f d) < f b.
Proof.
move=> sk sa ab bd ds ne; have ss : t s < t s.+1 := le_lt_trans sa (lt_trans ab (lt_le_trans bd ds)).
have uni x y z : t s < x -> x < y -> y < z -> z < t s.+1 -> Num.min (f x) (f z) < f y.
  move=> h1 h2 h3 h4; have tm : t s.+1 <= t k.+1 by apply: tle.
  rewrite !value_in ?(lt_le_trans _ tm) ?(lt_trans h3 h4) ?(lt_trans h2 (lt_trans h3 h4)) //.
  by apply: (paper_unimodal r_gt0 t_mono (k := k) (i := 0) (s := s)).
have low x y z : t s <= x -> x < y -> y < z -> z <= t s.+1 -> Num.min (f x) (f z) <= f y.
  move=> h1 h2 h3 h4; have h5 := lt_trans h2 h3.
  rewrite !(value_piece r_gt0 t_mono U sk ss) ?h1 ?h4 ?(ltW (lt_le_trans h3 h4)) ?(ltW (lt_le_trans h5 h4)) ?(ltW (le_lt_trans h1 h2)) ?(ltW (le_lt_trans h1 h5)) //.
  by apply: (@closed_low R r r_gt0 t t_mono k 0 _ s) => // s' x' y' z' hs; apply: (paper_unimodal r_gt0 t_mono).
have flat x y : t s <= x -> x < y -> y <= t s.+1 -> (forall z, x < z -> z < y -> f z = f b) -> False.
  move=> h1 h2 h3 H; have [p [q [w [q1 q2 q3 q4 _]]]] := between3 h2 (@ltr01 R).
  have := uni p q w (le_lt_trans h1 q1) q2 q3 (lt_le_trans q4 h3).
  have xq := lt_trans q1 q2; have qy := lt_trans q3 q4.
  by rewrite !H ?minxx ?ltxx // ?(lt_trans xq q3) ?(lt_trans q2 qy).
have lowb := low a b d sa ab bd ds; rewrite lt_neqAle lowb andbT; apply/negP => /eqP e.
case: (ltgtP (f a) (f d)) ne => // lt _; [rewrite (min_idPl (ltW lt)) in e|rewrite (min_idPr (ltW lt)) in e].
  apply: (flat a b) => // [|z z0 z1]; first exact: ltW (lt_le_trans bd ds).
  have h1 := low a z b sa z0 z1 (ltW (lt_le_trans bd ds)); have h2 := low z b d (ltW (le_lt_trans sa z0)) z1 bd ds.
  rewrite e minxx in h1; apply/eqP; rewrite eq_le h1 andbT; move: h2; rewrite le_minl => /orP[//|].
  by rewrite -e leNgt lt.
apply: (flat b d) => // [|z z0 z1]; first exact: ltW (le_lt_trans sa ab).
have h1 := low b z d (ltW (le_lt_trans sa ab)) z0 z1 ds; have h2 := low a b z sa ab z0 (ltW (lt_le_trans z1 ds)).
rewrite e minxx in h1; apply/eqP; rewrite eq_le h1 andbT; move: h2; rewrite le_minl => /orP[|//].
by rewrite -e leNgt lt.
Qed.
(* so the knot is a strict local minimum *)
Lemma valley_minimum l : (l < N)%N -> exists2 e, 0 < e & forall y, y != t l.+2 -> `|y - t l.+2| < e -> f (t l.+2) < f y.
Proof.
move=> lN; have [z /andP[z0 z1] hz] := low_left lN; have [z' /andP[z0' z1'] hz'] := low_right lN.
have zt : z < t l.+2 by rewrite lt_neqAle z1 andbT; apply/negP => /eqP e; rewrite e ltxx in hz.
have zt' : t l.+2 < z' by rewrite lt_neqAle z0' andbT; apply/negP => /eqP e; rewrite e ltxx in hz'.
exists (Num.min (t l.+2 - z) (z' - t l.+2)); first by rewrite lt_minr !subr_gt0 zt.
move=> y ny; rewrite lt_minr => /andP[c1 c2]; case: (ltgtP y (t l.+2)) ny => // yt _.
  have zy : z < y by move: c1; rewrite ltr0_norm ?subr_lt0 // opprB ltr_add2l ltr_opp2.
  have := @span_above l.+1 z y (t l.+2) _ z0 zy yt (lexx _); rewrite (min_idPr (ltW hz)) gt_eqF //; apply=> //.
  by move: lN; clear; lia.
have yz : y < z' by move: c2; rewrite gtr0_norm ?subr_gt0 // ltr_add2r.
have := @span_above l.+2 (t l.+2) y z' _ (lexx _) yt yz z1'; rewrite (min_idPl (ltW hz')) lt_eqF //; apply=> //.
by move: lN; clear; lia.
Qed.
End Valleys.

(* k - 1 local maxima are all that there are *)
Lemma all_maxima (R : rcfType) (r : R) (t : nat -> R) k (l : seq R) : 0 < r -> (forall i, t i <= t i.+1) -> (2 <= k)%N -> t 0%N < t k.+1 ->
  sorted <%R l -> size l = k.-1 -> (forall x, x \in l -> local_max (value r t k.+1 k 0) (t 0%N) (t k.+1) x) ->
  forall x, local_max (value r t k.+1 k 0) (t 0%N) (t k.+1) x <-> x \in l.
Proof.
move=> r0 tm k2 U sl zl H x; split; last exact: H.
move=> Mx; case: (boolP (x \in l)) => // xl; have ul : uniq (x :: l) by rewrite /= xl (sorted_uniq lt_trans ltxx sl).
have := @X_maxima_bound_printed R r t 0 k 0 (sort <=%R (x :: l)) r0 tm k2 (leqnn 0) U.
rewrite sort_lt_sorted ul size_sort /= zl ltnn => h; apply: h => // y.
by rewrite mem_sort inE => /orP[/eqP -> //|]; exact: H.
Qed.

(* X.maxima.most for every k >= 2 and every r <> 1: knots, of multiplicity at most k inside, on which G_0^k has exactly k - 1 local maxima
   on the closure of its support, and at each of t_2 < .. < t_(k-1) a strict local minimum; by X.maxima.bound no function of degree k has more *)
Theorem X_maxima_most (R : rcfType) (r : R) k : 0 < r -> r != 1 -> (2 <= k)%N -> exists (t : nat -> R) (l : seq R),
  [/\ forall i, t i <= t i.+1, t 0%N < t k.+1, forall y, t 0%N < y < t k.+1 -> (mult t k.+1 y <= k)%N,
   [/\ sorted <%R l, size l = k.-1 & forall x, local_max (value r t k.+1 k 0) (t 0%N) (t k.+1) x <-> x \in l] &
   forall j, (1 < j < k)%N -> t j.-1 < t j < t j.+1 /\
     exists2 e, 0 < e & forall y, y != t j -> `|y - t j| < e -> value r t k.+1 k 0 (t j) < value r t k.+1 k 0 y].
Proof.
move=> r0 r1 k2; suff [t [l [[tm U] [sl zl H] mins]]] : exists (t : nat -> R) (l : seq R), [/\ (forall i, t i <= t i.+1) /\ t 0%N < t k.+1,
    [/\ sorted <%R l, size l = k.-1 & forall x, x \in l -> local_max (value r t k.+1 k 0) (t 0%N) (t k.+1) x] &
    forall j, (1 < j < k)%N -> t j.-1 < t j < t j.+1 /\
      exists2 e, 0 < e & forall y, y != t j -> `|y - t j| < e -> value r t k.+1 k 0 (t j) < value r t k.+1 k 0 y].
  exists t, l; split=> // [y hy|]; last by split=> //; exact: all_maxima.
  by have [p [_ _ _ h]] := @mult_span_eq R t 0 k tm y hy; apply: (leq_ltn_trans (leq_addl _ _) h).
case: k k2 => [|[|N]] // _; case: (posnP N) => [->|N0].
  pose t i : R := i%:R; have tm i : t i <= t i.+1 by rewrite ler_nat.
  have U : t 0%N < t 3%N by rewrite ltr_nat.
  have [x hx H] := @knots_max R r r0 t tm 2 isT U 0%N 3%N isT.
  exists t, [:: x]; split=> // [|j /andP[j1 j2]]; last by move: j1 j2; clear; lia.
  split=> // y; rewrite inE => /eqP ->; split=> //; by exists 1; [exact: ltr01|move=> z hz _; apply: H].
have rho0 : 0 < r^-1 by rewrite invr_gt0. have rho1 : r^-1 != 1 by rewrite invr_eq1.
pose T := T r^-1 N; pose X := X r^-1 N; pose Y := Y r^-1 N; pose t := knots r N T X Y.
have T_lt l : T l < T l.+1 by exact: T_lt. have Y0 : 0 < Y by exact: Y_gt0.
have Tle l l' : (l <= l')%N -> T l <= T l' by apply: t_le => i; rewrite ltW.
pose f h := G (wt r (t h)) (t h) N.+2 0.
have V l : (l < N)%N -> soon (fun h =>
    (exists2 z, t h l.+1 <= z < t h l.+2 & f h (t h l.+2) < f h z) /\ (exists2 z, t h l.+2 <= z < t h l.+3 & f h (t h l.+2) < f h z)).
  move=> lN; have [e [e0 h1 h2 h3 h4]] := peaks rho0 rho1 lN; rewrite -/T -/X -/Y in h1 h2 h3 h4.
  have b0 : between N T l.+1 (T l) by split=> // j; [rewrite ltnS; exact: Tle|move=> lj _; apply: lt_le_trans (T_lt l) _; exact: Tle].
  have b1 : between N T l (T l - e).
    split=> [|j jl|j lj _]; [exact: ltnW| |by apply: (@lt_le_trans _ _ (T l)); [rewrite ltr_subl_addr ltr_addl|exact: Tle]].
    case: h1 => [l0|h1]; first by rewrite l0 in jl.
    by apply: le_trans (ltW h1); apply: Tle; move: jl; clear; lia.
  have b2 : between N T l.+1 (T l + e).
    split=> // [j jl|j lj _]; last by apply: (lt_le_trans h2); exact: Tle.
    by apply: (@le_trans _ _ (T l)); [exact: Tle|rewrite ler_addl ltW].
  have e1 := FF_S r^-1 N T X Y l; rewrite -e1 in h3.
  have c1 := G_compare r0 N0 T_lt Y0 b0 b1 h3. have c2 := G_compare r0 N0 T_lt Y0 b0 b2 h4.
  have p1 := place_soon r0 X Y b1. have p2 := place_soon r0 X Y b2.
  apply: soon_imp (soon_and (soon_and c1 c2) (soon_and p1 p2)) => h h0 [[q1 q2] [q3 q4]].
  have e2 : t h l.+2 = 1 + h * T l by exact: knots_in.
  by split; [exists (1 + h * (T l - e))|exists (1 + h * (T l + e))]; rewrite // e2.
have [d d0 D] := soon_and (soon_all V) (knots_ordered r0 N0 T_lt X Y0).
have hd : 0 < d / 2%:R < d by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
have [W mono] := D _ hd; rewrite -/t in mono; move: (d / 2%:R) W mono {D d0 hd} => h W mono.
have tle := t_le mono.
have val x : x < t h N.+3 -> value r (t h) N.+3 N.+2 0 x = f h x by move=> hx; rewrite value_in.
have fin l z : (l <= N)%N -> z < t h l.+2 -> z < t h N.+3 by move=> lN hz; apply: (lt_le_trans hz); apply: tle; move: lN; clear; lia.
have sp l : (l <= N)%N -> t h l.+1 < t h l.+2.
  rewrite leq_eqVlt => /orP[/eqP ->|lN]; last by have [[z /andP[z0 z1] _] _] := W l lN; apply: le_lt_trans z1.
  have lN : (N.-1 < N)%N by rewrite prednK.
  have [_ [z /andP[z0 z1] _]] := W _ lN; rewrite prednK // in z0 z1; exact: le_lt_trans z1.
have L l : (l < N)%N -> exists2 z, t h l.+1 <= z <= t h l.+2 & value r (t h) N.+3 N.+2 0 (t h l.+2) < value r (t h) N.+3 N.+2 0 z.
  move=> lN; have [[z /andP[z0 z1] lt] _] := W l lN; exists z; first by rewrite z0 ltW.
  by rewrite !val ?(fin l z) ?(ltnW lN) // (fin l.+1) // sp.
have L' l : (l < N)%N -> exists2 z, t h l.+2 <= z <= t h l.+3 & value r (t h) N.+3 N.+2 0 (t h l.+2) < value r (t h) N.+3 N.+2 0 z.
  move=> lN; have [_ [z /andP[z0 z1] lt]] := W l lN; exists z; first by rewrite z0 ltW.
  by rewrite !val ?(fin l.+1 z) // (fin l.+1) // sp.
have [xs [s1 s2 s3]] := valleys_maxima r0 mono N0 sp L L'.
exists (t h), xs; split=> // [|j /andP[]].
  by split=> //; apply: (le_lt_trans (mono 0%N)); apply: (lt_le_trans (sp 0%N (leq0n N))); exact: tle.
case: j => [|[|l]] // _; rewrite !ltnS => lN; split; first by rewrite /= !sp // ltnW.
exact: (valley_minimum r0 mono sp L L').
Qed.
