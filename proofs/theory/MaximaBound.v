(* A function of degree k >= 2 has at most k - 1 local maxima, for all knots: of the closed spans t_(i+1)..t_(i+k) each has at most one
   (Theorem 3), and on the first and the last span of the support the function rises and falls. No function jumps inside of its support. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify realalg.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis TwoMaxima Cumulative Minors Theorem3 Theorem3Rational.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* x is a local maximum of f on [a,b]: nothing near x is larger *)
Definition local_max (R : realFieldType) (f : R -> R) (a b x : R) :=
  a <= x <= b /\ exists2 e, 0 < e & forall y, a <= y <= b -> `|y - x| < e -> f y <= f x.

Section Near.
Variable R : realFieldType.
(* a value above c is above c near by, on either side *)
Lemma taylor_above (f : R -> R) x v l c : taylor f x v l -> c < v -> exists2 d, 0 < d & forall h, `|h| < d -> h != 0 -> c < f (x + h).
Proof.
move=> tf cv; have pos s : exists2 d, 0 < d & forall h, 0 < h < d -> c < f (x + s * h).
  have t1 := taylor_add (taylor_shift s tf) (taylor_const (- c) 0).
  have [|d d0 H] := taylor_pos t1; first by left; rewrite subr_gt0.
  by exists d => // h hh; have := H _ hh; rewrite subr_gt0.
have [d1 d10 H1] := pos 1; have [d2 d20 H2] := pos (-1).
exists (Num.min d1 d2); first by rewrite lt_minr d10.
move=> h; rewrite lt_minr => /andP[a1 a2] h0; case: (ltgtP h 0) => hs; last by rewrite hs eqxx in h0.
  by rewrite -[h]opprK -mulN1r; apply: H2; rewrite oppr_gt0 hs -(ltr0_norm hs).
by rewrite -[h]mul1r; apply: H1; rewrite hs -(gtr0_norm hs).
Qed.
(* two positive numbers are larger than a third *)
Lemma small2 (a b : R) : 0 < a -> 0 < b -> exists h, [/\ 0 < h, h < a & h < b].
Proof.
move=> a0 b0; have m0 : 0 < Num.min a b by rewrite lt_minr a0.
have : 0 < Num.min a b / 2%:R < Num.min a b by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
by move=> /andP[h0]; rewrite lt_minr => /andP[ha hb]; exists (Num.min a b / 2%:R).
Qed.
(* three points between x and y, near x if asked *)
Lemma between3 (x y e : R) : x < y -> 0 < e -> exists a b c, [/\ x < a, a < b, b < c, c < y & c < x + e].
Proof.
move=> xy e0; have [h [h0 h1 h2]] := small2 e0 (b := y - x) ltac:(by rewrite subr_gt0).
exists (x + h / 4%:R), (x + h / 2%:R), (x + h); split.
- by rewrite ltr_addl divr_gt0 // ltr0n.
- by rewrite ltr_add2l ltr_pmul2l // ltf_pinv ?posrE ?ltr0n // ltr_nat.
- by rewrite ltr_add2l ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
- by rewrite addrC -ltr_subr_addr.
by rewrite ltr_add2l.
Qed.
(* or near y *)
Lemma between3_left (x y e : R) : x < y -> 0 < e -> exists a b c, [/\ x < c, c < b, b < a, a < y & y - e < c].
Proof.
move=> xy e0; have [|a [b [c [h1 h2 h3 h4 h5]]]] := between3 (x := - y) (y := - x) _ e0; first by rewrite ltr_opp2.
exists (- a), (- b), (- c); rewrite !ltr_opp2 ltr_oppr h4 h3 h2 ltr_oppl h1; split=> //.
by rewrite ltr_oppr opprB addrC.
Qed.
End Near.

(* points of which each of j intervals has one at most *)
Section Count.
Variable R : realFieldType.
Variable t : nat -> R.
Lemma sorted_min (x : R) l : sorted <%R (x :: l) -> forall y, y \in l -> x < y.
Proof. by move=> h y; move: h; rewrite /= lt_path_sortedE => /andP[/allP h _] /h. Qed.
Lemma count_open j a (M : R -> Prop) l : (forall s x y, (a <= s < a + j)%N -> M x -> M y -> x < y -> t s <= x -> y <= t s.+1 -> False) ->
  sorted <%R l -> (forall x, x \in l -> M x /\ t a < x <= t (a + j)%N) -> (size l <= j)%N.
Proof.
elim: j a l => [|j IH] a l one sl H.
  case: l sl H => // x l _ /(_ x (mem_head _ _)) [_]; rewrite addn0 => /andP[h1 h2].
  by have := lt_le_trans h1 h2; rewrite ltxx.
have one' s x y : (a.+1 <= s < a.+1 + j)%N -> M x -> M y -> x < y -> t s <= x -> y <= t s.+1 -> False.
  by move=> hs; apply: one; move: hs; clear; lia.
case: l sl H => // x l sl H; have lt := sorted_min sl; have sl' : sorted <%R l := path_sorted sl.
have [Mx /andP[x1 x2]] := H x (mem_head _ _).
case: (leP x (t a.+1)) => xa.
  rewrite /= ltnS; apply: (IH a.+1) => // y yl; have [My /andP[y1 y2]] := H y ltac:(by rewrite inE yl orbT).
  split => //; rewrite addSnnS y2 andbT ltNge; apply/negP => ya.
  by apply: (one a x y) => //; [clear; lia|apply: lt|exact: ltW].
apply: leqW; apply: (IH a.+1) => // y yl; have [My /andP[y1 y2]] := H y yl; split => //; rewrite addSnnS y2 andbT.
by move: yl; rewrite inE => /orP[/eqP ->|/lt /(lt_trans xa)].
Qed.
Lemma count_closed j a (M : R -> Prop) l : (0 < j)%N ->
  (forall s x y, (a <= s < a + j)%N -> M x -> M y -> x < y -> t s <= x -> y <= t s.+1 -> False) ->
  sorted <%R l -> (forall x, x \in l -> M x /\ t a <= x <= t (a + j)%N) -> (size l <= j)%N.
Proof.
case: j => // j _ one sl H; have one' s x y : (a.+1 <= s < a.+1 + j)%N -> M x -> M y -> x < y -> t s <= x -> y <= t s.+1 -> False.
  by move=> hs; apply: one; move: hs; clear; lia.
case: l sl H => // x l sl H; have lt := sorted_min sl; have sl' : sorted <%R l := path_sorted sl.
have [Mx /andP[x1 x2]] := H x (mem_head _ _).
rewrite /= ltnS; apply: (count_open one') => // y yl; have [My /andP[y1 y2]] := H y ltac:(by rewrite inE yl orbT).
split => //; rewrite addSnnS y2 andbT ltNge; apply/negP => ya.
by apply: (one a x y) => //; [clear; lia|apply: lt].
Qed.
End Count.

Section Bound.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k i : nat.
Local Notation m := (n + k.+1)%N.
Hypothesis k0 : (0 < k)%N.
Hypothesis i_n : (i <= n)%N.
Hypothesis U : t 0%N < t m.
Local Notation G := (G (wt r t) t).
Local Notation f := (value r t m k i).
Local Notation M := (local_max f (t i) (t (i + k.+1)%N)).
(* Theorem 3 *)
Hypothesis unimodal : forall s x y z, (i <= s <= i + k)%N -> t s < x -> x < y -> y < z -> z < t s.+1 -> Num.min (G k i x) (G k i z) < G k i y.
Let tle := t_le t_mono.
Let im : (i + k.+1 <= m)%N. Proof. by rewrite leq_add2r. Qed.

(* on the first span the functions rise *)
Lemma first_rises d x y : t i <= x -> x < y -> y < t i.+1 -> G d i x <= G d i y /\ ((0 < d)%N -> G d i x < G d i y).
Proof.
move=> x0 xy y1; have hx : t i <= x < t i.+1 by rewrite x0 (lt_trans xy). have hy : t i <= y < t i.+1 by rewrite (le_trans x0 (ltW xy)).
elim: d => [|d [IH _]]; first by rewrite !G0 hx hy.
suff h : G d.+1 i x < G d.+1 i y by split => //; apply: ltW.
have z u : t i <= u < t i.+1 -> G d i.+1 u = 0.
  by move=> hu; apply: T3_5_1_outside => //; rewrite negb_and -ltNge; case/andP: hu => _ ->.
rewrite !GS !z // !mulr0 !addr0.
have yt : y < t (i + d.+1)%N by apply: (lt_le_trans y1); rewrite addnS; apply: tle; rewrite ltnS leq_addr.
have w1 : wt r t d.+1 i x < wt r t d.+1 i y by apply: phi_shape_mono.
have w0 : 0 <= wt r t d.+1 i x by case/andP: (wt_range r_gt0 t d.+1 i x).
have Gy : 0 < G d i y.
  apply: T3_5_2 => //; [exact: wt_left|exact: wt_range|exact: wt_inside|].
  by rewrite (le_lt_trans x0 xy).
apply: (@le_lt_trans _ _ (wt r t d.+1 i x * G d i y)); first by rewrite ler_wpmul2l.
by rewrite ltr_pmul2r.
Qed.
(* on the last span they fall *)
Lemma last_falls d j x y : t (j + d)%N <= x -> x < y -> y < t (j + d).+1 -> G d j y <= G d j x /\ ((0 < d)%N -> G d j y < G d j x).
Proof.
elim: d j => [|d IH] j.
  by rewrite !addn0 => x0 xy y1; rewrite !G0 x0 y1 (lt_trans xy) // (le_trans x0 (ltW xy)).
move=> x0 xy y1; have xs : x < t (j + d.+1).+1 := lt_trans xy y1.
have ys : t (j + d.+1)%N <= y := le_trans x0 (ltW xy).
suff h : G d.+1 j y < G d.+1 j x by split => //; apply: ltW.
have z u : t (j + d.+1)%N <= u -> G d j u = 0.
  by move=> hu; apply: T3_5_1_outside => //; rewrite negb_and orbC -leNgt hu.
rewrite !GS !z // !mulr0 !add0r.
have E : (j.+1 + d.+1 = (j + d.+1).+1)%N by []. have E' : (j.+1 + d = j + d.+1)%N by rewrite addSnnS.
have [g _] := IH j.+1 ltac:(by rewrite E') xy ltac:(by rewrite E').
have x1 : t j.+1 <= x by apply: le_trans x0; apply: tle; rewrite addnS ltnS leq_addr.
have w1 : wt r t d.+1 j.+1 x < wt r t d.+1 j.+1 y by apply: phi_shape_mono => //; rewrite E.
have w0 : wt r t d.+1 j.+1 x < 1 by case/andP: (phi_range r_gt0 x (t j.+1) (t (j.+1 + d.+1)%N)).
have w2 : 0 < 1 - wt r t d.+1 j.+1 y by rewrite subr_gt0; case/andP: (phi_range r_gt0 y (t j.+1) (t (j.+1 + d.+1)%N)).
have Gy : 0 < G d j.+1 y.
  apply: T3_5_2 => //; [exact: wt_left|exact: wt_range|exact: wt_inside|].
  by rewrite (le_lt_trans x1 xy) E.
apply: (@lt_le_trans _ _ ((1 - wt r t d.+1 j.+1 x) * G d j.+1 y)); first by rewrite ltr_pmul2r // ltr_add2l ltr_opp2.
by rewrite ler_wpmul2l // subr_ge0 ltW.
Qed.

(* a local maximum is on no span but those in the middle, closed *)
Lemma after_first x : t i < t i.+1 -> M x -> t i.+1 <= x.
Proof.
move=> h [/andP[x0 xb] [e e0 H]]; rewrite leNgt; apply/negP => x1.
have [g [g0 g1 g2]] := small2 e0 (b := t i.+1 - x) ltac:(by rewrite subr_gt0).
have yt : x + g < t i.+1 by rewrite addrC -ltr_subr_addr.
have tt : t i.+1 <= t (i + k.+1)%N by apply: tle; rewrite addnS ltnS leq_addr.
have tm : t i.+1 <= t m by apply: le_trans tt _; apply: tle.
have xg : x < x + g by rewrite ltr_addl.
have := H (x + g) ltac:(by rewrite (le_trans x0 (ltW xg)) (le_trans (ltW yt))) ltac:(by rewrite addrAC subrr add0r gtr0_norm).
rewrite !value_in ?(lt_le_trans _ tm) //; rewrite leNgt; apply/negP; rewrite negbK.
by have [_] := first_rises k x0 xg yt; apply.
Qed.
Lemma zero_after : t (i + k)%N < t (i + k).+1 -> f (t (i + k.+1)%N) = 0.
Proof.
move=> h; apply: T3_5_1_amended => //.
- by rewrite ltxx andbF.
- by rewrite addnS => -[e1 [e2 e3]]; move: e3; rewrite e1 e2 ltxx.
move=> [_ [e1 e2]]; move: h; rewrite -addnS -e2 -e1 ltNge tle //.
by rewrite -addn1 leq_add2l.
Qed.
Lemma before_last x : t (i + k)%N < t (i + k).+1 -> M x -> x <= t (i + k)%N.
Proof.
move=> h [/andP[x0 xb] [e e0 H]]; rewrite leNgt; apply/negP => x1.
have [g [g0 g1 g2]] := small2 e0 (b := x - t (i + k)%N) ltac:(by rewrite subr_gt0).
have yt : t (i + k)%N < x - g by rewrite ltr_subr_addr addrC -ltr_subr_addr.
have xg : x - g < x by rewrite ltr_subl_addr ltr_addl.
have it : t i <= t (i + k)%N by apply: tle; rewrite leq_addr.
have yb : x - g < t (i + k.+1)%N := lt_le_trans xg xb.
have := H (x - g) ltac:(by rewrite (le_trans it (ltW yt)) ltW) ltac:(by rewrite addrAC subrr add0r normrN gtr0_norm).
rewrite leNgt; apply/negP; rewrite negbK.
move: xb; rewrite le_eqVlt => /orP[/eqP xe|xb].
  have -> : f x = 0 by rewrite xe zero_after.
  by apply: T3_5_2_printed => //; rewrite (le_lt_trans it yt).
have tm : t (i + k.+1)%N <= t m by apply: tle.
rewrite !value_in ?(lt_le_trans _ tm) //.
by have [_] := last_falls (ltW yt) xg ltac:(by rewrite -addnS); apply.
Qed.
(* inside of the support every knot occurs at most k times *)
Lemma inside_mult y : t i < y < t (i + k.+1)%N -> (mult t m y <= k)%N.
Proof.
move=> /andP[y1 y2]; have hy : t 0%N < y < t m by rewrite (le_lt_trans (tle (leq0n i)) y1) (lt_le_trans y2) ?tle.
have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hy; case: (posnP (mult t m y)) => [->//|q0].
have ip : (i <= p)%N.
  rewrite leqNgt; apply/negP => h; move: y1; rewrite ltNge -(p2 p.+1) ?tle //; last by rewrite ltnSn -addn1 leq_add2l.
have pi : (p + mult t m y < i + k.+1)%N.
  by apply: (t_lt_ltn t_mono); rewrite p2 // leqnn andbT -[X in (X < _)%N]addn0 ltn_add2l.
by move: ip pi; clear; lia.
Qed.
(* on a closed span the values are those of the piece, at a local maximum *)
Lemma closed_value s x : (i <= s <= i + k)%N -> t s < t s.+1 -> t s <= x <= t s.+1 -> M x -> f x = P r t s k i x.
Proof.
move=> /andP[s1 s2] ss /andP[x0 x1] Mx.
have sm : (s < m)%N by move: s2 i_n; clear; lia.
have tsm : t s.+1 <= t m by apply: tle.
move: x1; rewrite le_eqVlt => /orP[/eqP e|x1]; last first.
  by rewrite value_in ?(lt_le_trans x1 tsm) // (G_P r t_mono k i (s := s)) // x0.
have L : left_span t m x = s by apply: left_span_uniq => //; rewrite e ss lexx.
case: (eqVneq x (t m)) => [xm|xm].
  by rewrite xm value_tm; congr (P _ _ _ _ _ _); apply: last_span_uniq => //; rewrite -e xm.
have ti : t i < x by rewrite e (le_lt_trans (tle s1) ss).
have xb : x <= t (i + k.+1)%N by case: Mx => /andP[].
move: xb; rewrite le_eqVlt => /orP[/eqP eb|xb].
  (* not a local maximum: the value is 0 there *)
  have xm' : x < t m by rewrite lt_neqAle xm e.
  have f0 : f x = 0.
    rewrite value_in //; apply: T3_5_1_outside => //; first by rewrite eb ltxx andbF.
  case: Mx => _ [d d0 H].
  have [g [g0 g1 g2]] := small2 d0 (b := x - t i) ltac:(by rewrite subr_gt0).
  have xg : x - g < x by rewrite ltr_subl_addr ltr_addl.
  have it : t i < x - g by rewrite ltr_subr_addr addrC -ltr_subr_addr.
  have := H (x - g) ltac:(by rewrite (ltW it) -eb ltW) ltac:(by rewrite addrAC subrr add0r normrN gtr0_norm).
  by rewrite f0 leNgt T3_5_2_printed // it -eb.
have hk := inside_mult (introT andP (conj ti xb)).
have hy : t 0%N < x < t m by rewrite (le_lt_trans (tle (leq0n i)) ti) (lt_le_trans xb) ?tle.
have [p [p1 p2 pm E]] := P3_1_2_paper r_gt0 t_mono i hy hk.
rewrite value_in ?E; last by case/andP: hy.
by rewrite -(left_span_uniq t_mono pm (x := x)) ?p1 // L.
Qed.
(* on a closed span the piece is nowhere below two values around *)
Lemma closed_low s x b y : (i <= s <= i + k)%N -> t s <= x -> x < b -> b < y -> y <= t s.+1 ->
  Num.min (P r t s k i x) (P r t s k i y) <= P r t s k i b.
Proof.
move=> hs sx xb bY ys; have xy := lt_trans xb bY; have ss : t s < t s.+1 := le_lt_trans sx (lt_le_trans xy ys).
have hx : t s <= x <= t s.+1 by rewrite sx (le_trans (ltW xy)).
have hy : t s <= y <= t s.+1 by rewrite ys (le_trans sx (ltW xy)).
rewrite leNgt; apply/negP; rewrite lt_minr => /andP[hx1 hy1].
have [d d0 Hd] := taylor_above (P_taylor r_gt0 t_mono k i ss hx) hx1; have [d' d0' Hd'] := taylor_above (P_taylor r_gt0 t_mono k i ss hy) hy1.
have [g [g0 g1 g2]] := small2 d0 (b := b - x) ltac:(by rewrite subr_gt0).
have [g' [g0' g1' g2']] := small2 d0' (b := y - b) ltac:(by rewrite subr_gt0).
have a1 : x < x + g by rewrite ltr_addl. have a2 : x + g < b by rewrite addrC -ltr_subr_addr.
have c1 : b < y - g' by rewrite ltr_subr_addr addrC -ltr_subr_addr. have c2 : y - g' < y by rewrite ltr_subl_addr ltr_addl.
have inn z : x < z -> z < y -> G k i z = P r t s k i z.
  by move=> xz zy; apply: G_P => //; rewrite (le_trans sx (ltW xz)) (lt_le_trans zy ys).
have := @unimodal s (x + g) b (y - g') hs (le_lt_trans sx a1) a2 c1 (lt_le_trans c2 ys).
rewrite !inn ?(lt_trans a2 bY) ?(lt_trans xb c1) // lt_minl.
by rewrite ltNge ltW ?Hd ?gtr0_norm ?gt_eqF //= ltNge ltW // Hd' ?normrN ?gtr0_norm // oppr_eq0 gt_eqF.
Qed.
(* a closed span has one local maximum at most *)
Lemma one_a_span s x y : (i <= s <= i + k)%N -> M x -> M y -> x < y -> t s <= x -> y <= t s.+1 -> False.
Proof.
move=> hs Mx My xy sx ys; have ss : t s < t s.+1 := le_lt_trans sx (lt_le_trans xy ys).
have sm : (s < m)%N by case/andP: hs => _ s2; move: s2 i_n; clear; lia.
have tsm : t s.+1 <= t m by apply: tle.
have hx : t s <= x <= t s.+1 by rewrite sx (le_trans (ltW xy)).
have hy : t s <= y <= t s.+1 by rewrite ys (le_trans sx (ltW xy)).
have xs : x < t s.+1 := lt_le_trans xy ys. have sy : t s < y := le_lt_trans sx xy.
have ex := closed_value hs ss hx Mx. have ey := closed_value hs ss hy My.
have inn z : x < z -> z < y -> f z = P r t s k i z /\ f z = G k i z.
  move=> xz zy; have zs : z < t s.+1 := lt_le_trans zy ys.
  by rewrite value_in ?(lt_le_trans zs tsm) // (G_P r t_mono k i (s := s)) // (le_trans sx (ltW xz)).
have uni a b c : x < a -> a < b -> b < c -> c < y -> Num.min (f a) (f c) < f b.
  move=> xa ab bc cy; have xb := lt_trans xa ab; have bx := lt_trans bc cy.
  rewrite (proj2 (inn a xa (lt_trans ab bx))) (proj2 (inn b xb bx)) (proj2 (inn c (lt_trans xb bc) cy)).
  by apply: (unimodal hs) => //; [exact: le_lt_trans xa|exact: lt_le_trans ys].
have low b : x < b -> b < y -> Num.min (f x) (f y) <= f b.
  by move=> xb bY; rewrite ex ey (proj1 (inn b xb bY)); apply: closed_low.
have [Rx [e e0 Hx]] := Mx; have [Ry [e' e0' Hy]] := My.
have dom z : x < z -> z < y -> t i <= z <= t (i + k.+1)%N.
  move=> xz zy; case/andP: Rx => x0 _; case/andP: Ry => _ y1.
  by rewrite (le_trans x0 (ltW xz)) (le_trans (ltW zy)).
case: (leP (f x) (f y)) => xy'.
  have [a [b [c [xa ab bc cy ce]]]] := between3 xy e0.
  have xb := lt_trans xa ab; have xc := lt_trans xb bc; have b_y := lt_trans bc cy; have a_y := lt_trans ab b_y.
  have up z : x < z -> z < y -> z <= c -> f z <= f x.
    move=> xz zy zc; apply: Hx; first exact: dom.
    by rewrite gtr0_norm ?subr_gt0 // ltr_subl_addr addrC (le_lt_trans zc).
  have lo z : x < z -> z < y -> f x <= f z by move=> xz zy; have := low z xz zy; rewrite (min_idPl xy').
  have := uni a b c xa ab bc cy.
  rewrite lt_minl !ltNge (le_trans (up b xb b_y (ltW bc)) (lo a xa a_y)) (le_trans (up b xb b_y (ltW bc)) (lo c xc cy)) //.
have [a [b [c [xc cb ba ay ce]]]] := between3_left xy e0'.
have xb := lt_trans xc cb; have xa := lt_trans xb ba; have b_y := lt_trans ba ay; have c_y := lt_trans cb b_y.
have up z : x < z -> z < y -> c <= z -> f z <= f y.
  move=> xz zy cz; apply: Hy; first exact: dom.
  by rewrite ltr0_norm ?subr_lt0 // opprB ltr_subl_addr addrC -ltr_subl_addr (lt_le_trans ce).
have lo z : x < z -> z < y -> f y <= f z by move=> xz zy; have := low z xz zy; rewrite (min_idPr (ltW xy')).
have := uni c b a xc cb ba ay.
by rewrite lt_minl !ltNge (le_trans (up b xb b_y (ltW cb)) (lo a xa ay)) (le_trans (up b xb b_y (ltW cb)) (lo c xc c_y)).
Qed.
(* the count *)
Theorem maxima_count l : (2 <= k)%N -> t i < t (i + k.+1)%N -> sorted <%R l -> (forall x, x \in l -> M x) -> (size l <= k.-1)%N.
Proof.
move=> k2 h sl H.
have lo x : x \in l -> t i.+1 <= x.
  move=> xl; case: (ltP (t i) (t i.+1)) => e; first by apply: after_first => //; apply: H.
  by have [/andP[x0 _] _] := H x xl; apply: le_trans x0.
have hi x : x \in l -> x <= t (i + k)%N.
  move=> xl; case: (ltP (t (i + k)%N) (t (i + k).+1)) => e; first by apply: before_last => //; apply: H.
  by have [/andP[_ x1] _] := H x xl; apply: le_trans e; rewrite -addnS.
have k1 : (0 < k.-1)%N by move: k2; clear; lia.
apply: (@count_closed _ t k.-1 i.+1 M) => // [s x y hs|x xl]; last first.
  split; first exact: H.
  rewrite lo //; have -> : (i.+1 + k.-1 = i + k)%N by move: k0; clear; lia.
  exact: hi.
by apply: one_a_span; move: hs k0; clear; lia.
Qed.
End Bound.

(* X.maxima.bound: a function of degree k >= 2 has at most k - 1 local maxima on the closure of its support: so many points at most
   are local maxima there (no interval of constancy is among them), real closed fields. No function need be continuous on (t_0,t_m). *)
Theorem X_maxima_bound_printed (R : rcfType) (r : R) (t : nat -> R) n k i (l : seq R) : 0 < r -> (forall j, t j <= t j.+1) ->
  (2 <= k)%N -> (i <= n)%N -> t i < t (i + k.+1)%N -> sorted <%R l ->
  (forall x, x \in l -> local_max (value r t (n + k.+1) k i) (t i) (t (i + k.+1)%N) x) -> (size l <= k.-1)%N.
Proof.
move=> r0 tm k2 im h; have k0 : (0 < k)%N := ltnW k2.
have U : t 0%N < t (n + k.+1)%N.
  by apply: (le_lt_trans (t_le tm (leq0n i))); apply: (lt_le_trans h); apply: t_le => //; rewrite leq_add2r.
apply: (maxima_count r0 tm k0 im U _ k2 h) => s x y z hs; exact: (paper_unimodal r0 tm k0 hs).
Qed.
(* X.maxima.bound: the same for rational knots, ratio and points *)
Theorem rational_maxima_bound (r : rat) (t : nat -> rat) n k i (l : seq rat) : 0 < r -> (forall j, t j <= t j.+1) ->
  (2 <= k)%N -> (i <= n)%N -> t i < t (i + k.+1)%N -> sorted <%R l ->
  (forall x, x \in l -> local_max (value r t (n + k.+1) k i) (t i) (t (i + k.+1)%N) x) -> (size l <= k.-1)%N.
Proof.
move=> r0 tm k2 im h; have k0 : (0 < k)%N := ltnW k2.
have U : t 0%N < t (n + k.+1)%N.
  by apply: (le_lt_trans (t_le tm (leq0n i))); apply: (lt_le_trans h); apply: t_le => //; rewrite leq_add2r.
apply: (maxima_count r0 tm k0 im U _ k2 h) => s x y z hs; exact: (rational_unimodal r0 tm k0 hs).
Qed.
