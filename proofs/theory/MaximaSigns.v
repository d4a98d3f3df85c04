(* From signs to maxima: where the derivative of G_0^k on t_0..t_(k+1) is negative from the left and positive from the right at N knots, there
   are N + 1 local maxima; and two for every degree k >= 3 and every r <> 1, which is the most that there can be for k = 3. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values StatementsBasis MaximaBound WeakConjecture.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Signs.
Variable R : rcfType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variable k : nat.
Hypothesis k0 : (0 < k)%N.
Hypothesis U : t 0%N < t k.+1.
Local Notation f := (value r t k.+1 k 0).
Local Notation M := (local_max f (t 0%N) (t k.+1)).
Let tle := t_le t_mono.
(* on a closed span the values are those of the piece *)
Lemma value_piece s y : (s <= k)%N -> t s < t s.+1 -> t s <= y <= t s.+1 -> f y = P r t s k 0 y.
Proof.
move=> sk ss /andP[y0 y1]; have tm : t s.+1 <= t k.+1 by apply: tle.
move: y1; rewrite le_eqVlt => /orP[/eqP e|y1]; last by rewrite value_in ?(lt_le_trans y1) //; apply: G_P => //; rewrite y0.
have sy : t s < y <= t s.+1 by rewrite e ss lexx.
move: tm; rewrite -e le_eqVlt => /orP[/eqP em|lt].
  by rewrite em value_tm; congr (P _ _ _ _ _ _); apply: last_span_uniq => //; rewrite -e em.
have hy : t 0%N < y < t k.+1 by rewrite lt andbT e (le_lt_trans (tle (leq0n s))).
have hk : (mult t k.+1 y <= k)%N by apply: (@inside_mult R t t_mono 0 k 0).
have [p [p1 p2 pm E]] := P3_1_2_paper r_gt0 t_mono 0 hy hk.
by rewrite value_in // E -(left_span_uniq t_mono pm (x := y)) ?p1 // (left_span_uniq t_mono (s := s)).
Qed.
(* a largest value between two knots *)
Lemma knots_max a b : (a <= b <= k.+1)%N -> exists2 x, t a <= x <= t b & forall y, t a <= y <= t b -> f y <= f x.
Proof.
elim: b => [|b IH] /andP[ab bk].
  move: ab; rewrite leqn0 => /eqP ->; exists (t 0%N); first by rewrite lexx.
  by move=> y; rewrite -eq_le => /eqP <-.
move: ab; rewrite leq_eqVlt => /orP[/eqP ->|ab].
  exists (t b.+1); first by rewrite lexx.
  by move=> y; rewrite -eq_le => /eqP <-.
have [|x /andP[x0 x1] H] := IH; first by rewrite -ltnS ab ltnW.
have ta : t a <= t b by apply: tle.
case: (ltP (t b) (t b.+1)) => bb; last first.
  have e : t b.+1 = t b by apply/eqP; rewrite eq_le bb t_mono.
  by exists x; rewrite e // x0.
have hs : (0 <= b <= 0 + k)%N by rewrite add0n.
have [x' /andP[z0 z1] H'] := span_max r_gt0 t_mono k0 hs bb.
have V y : t b <= y <= t b.+1 -> f y = P r t b k 0 y by apply: value_piece.
have up M y : f x <= M -> f x' <= M -> t a <= y <= t b.+1 -> f y <= M.
  move=> m1 m2 /andP[y0 y1]; case: (leP y (t b)) => yb; first by apply: le_trans m1; apply: H; rewrite y0.
  apply: le_trans m2; rewrite !V ?z0 ?(ltW yb) //; apply: H'; by rewrite (ltW yb).
case: (leP (f x) (f x')) => c.
  exists x'; first by rewrite (le_trans ta z0).
  by move=> y; apply: up.
exists x; first by rewrite x0 (le_trans x1) // ltW.
by move=> y; apply: up => //; exact: ltW.
Qed.
Local Notation Dl := (Dleft r t k.+1 k 0).
Local Notation Dr := (Dright r t k.+1 k 0).
Lemma rise_after x e : t 0%N <= x < t k.+1 -> 0 < Dr x -> 0 < e -> exists z, [/\ 0 < z, z < e, x + z <= t k.+1 & f x < f (x + z)].
Proof.
move=> hx dp e0; have [sm /andP[s0 s1]] := right_spanP hx; set s := right_span t k.+1 x in sm s0 s1 *.
have ss := le_lt_trans s0 s1; have xs : t s <= x <= t s.+1 by rewrite s0 ltW.
have [d d0 H] := taylor_rise (P_taylor r_gt0 t_mono k 0 ss xs) dp.
have [z [z0 z1 z2]] := small2 d0 e0; have [w [w0 w1 w2]] := small2 z0 (b := t s.+1 - x) ltac:(by rewrite subr_gt0).
have xw : x + w < t s.+1 by rewrite addrC -ltr_subr_addr.
exists w; split=> //; [exact: lt_trans z2|by apply: le_trans (ltW xw) _; apply: tle|].
have [h _] := H w ltac:(by rewrite w0 (lt_trans w1)).
rewrite !(value_piece _ ss) //; by rewrite (ltW xw) andbT (le_trans s0) // ler_addl ltW.
Qed.
Lemma fall_before x e : t 0%N < x <= t k.+1 -> Dl x < 0 -> 0 < e -> exists z, [/\ 0 < z, z < e, t 0%N <= x - z & f x < f (x - z)].
Proof.
move=> hx dn e0; have [sm /andP[s0 s1]] := left_spanP hx; set s := left_span t k.+1 x in sm s0 s1 *.
have ss := lt_le_trans s0 s1; have xs : t s <= x <= t s.+1 by rewrite s1 ltW.
have [d d0 H] := taylor_fall (P_taylor r_gt0 t_mono k 0 ss xs) dn.
have [z [z0 z1 z2]] := small2 d0 e0; have [w [w0 w1 w2]] := small2 z0 (b := x - t s) ltac:(by rewrite subr_gt0).
have xw : t s < x - w by rewrite ltr_subr_addr addrC -ltr_subr_addr.
exists w; split=> //; [exact: lt_trans z2|by apply: (le_trans (tle (leq0n s))); exact: ltW|].
have [_ h] := H w ltac:(by rewrite w0 (lt_trans w1)).
rewrite !(value_piece _ ss) //; by rewrite (ltW xw) (le_trans _ s1) // ler_subl_addr ler_addl ltW.
Qed.
(* between two knots, each of which has a lower value than some point between them, there is a local maximum *)
Lemma peak_values a b : (a <= b <= k.+1)%N -> t a < t b ->
  a = 0%N \/ (exists2 z, t a <= z <= t b & f (t a) < f z) -> b = k.+1 \/ (exists2 z, t a <= z <= t b & f (t b) < f z) ->
  exists x, [/\ M x, t a <= x <= t b, a = 0%N \/ t a < x & b = k.+1 \/ x < t b].
Proof.
move=> abk ab ha hb; have [x /andP[x0 x1] H] := knots_max abk; have /andP[_ bk] := abk.
have t0a : t 0%N <= t a by apply: tle. have tbm : t b <= t k.+1 by apply: tle.
have la : a = 0%N \/ t a < x.
  case: ha => [->|[z hz lt]]; [by left|right]; rewrite lt_neqAle x0 andbT; apply/negP => /eqP e.
  by have := H z hz; rewrite -e leNgt lt.
have lb : b = k.+1 \/ x < t b.
  case: hb => [->|[z hz lt]]; [by left|right]; rewrite lt_neqAle x1 andbT; apply/negP => /eqP e.
  by have := H z hz; rewrite e leNgt lt.
exists x; split=> //; last by rewrite x0.
split; first by rewrite (le_trans t0a) // (le_trans x1).
have [e1 e10 H1] : exists2 e, 0 < e & forall y, t 0%N <= y -> `|y - x| < e -> t a <= y.
  case: la => [->|lt]; first by exists 1; first exact: ltr01.
  exists (x - t a); first by rewrite subr_gt0.
  by move=> y _; rewrite ltr_norml => /andP[h _]; move: h; rewrite opprB ltr_add2r => /ltW.
have [e2 e20 H2] : exists2 e, 0 < e & forall y, y <= t k.+1 -> `|y - x| < e -> y <= t b.
  case: lb => [->|lt]; first by exists 1; first exact: ltr01.
  exists (t b - x); first by rewrite subr_gt0.
  by move=> y _; rewrite ltr_norml => /andP[_]; rewrite ltr_add2r => /ltW.
exists (Num.min e1 e2); first by rewrite lt_minr e10.
by move=> y /andP[y0 y1]; rewrite lt_minr => /andP[c1 c2]; apply: H; rewrite H1 ?H2.
Qed.
(* between two knots, where the function rises after the first and falls before the second, there is a local maximum *)
Lemma peak a b : (a <= b <= k.+1)%N -> t a < t b -> a = 0%N \/ 0 < Dr (t a) -> b = k.+1 \/ Dl (t b) < 0 ->
  exists x, [/\ M x, t a <= x <= t b, a = 0%N \/ t a < x & b = k.+1 \/ x < t b].
Proof.
move=> abk ab ha hb; have /andP[_ bk] := abk; have t0a : t 0%N <= t a by apply: tle. have tbm : t b <= t k.+1 by apply: tle.
apply: (peak_values abk ab).
  case: ha => [->|dp]; [by left|right].
  have [|z [z0 z1 z2 lt]] := rise_after (x := t a) (e := t b - t a) _ dp ltac:(by rewrite subr_gt0); first by rewrite t0a (lt_le_trans ab).
  exists (t a + z) => //; rewrite ler_addl (ltW z0) /= addrC -ler_subr_addr; exact: ltW.
case: hb => [->|dn]; [by left|right].
have [|z [z0 z1 z2 lt]] := fall_before (x := t b) (e := t b - t a) _ dn ltac:(by rewrite subr_gt0); first by rewrite tbm (le_lt_trans t0a).
exists (t b - z) => //; rewrite ler_subr_addr addrC -ler_subr_addr (ltW z1) /= ler_subl_addr ler_addl; exact: ltW.
Qed.
(* X.maxima.most, the count: N knots at which the derivative is negative from the left and positive from the right make N + 1 local maxima *)
Theorem signs_maxima l : path (fun a b => (a < b)%N && (t a < t b)) 0%N (rcons l k.+1) -> (forall a, a \in l -> Dl (t a) < 0 /\ 0 < Dr (t a)) ->
  exists xs : seq R, [/\ sorted <%R xs, size xs = (size l).+1 & forall x, x \in xs -> M x].
Proof.
move=> pl H; suff G a : a = 0%N \/ 0 < Dr (t a) -> path (fun a b => (a < b)%N && (t a < t b)) a (rcons l k.+1) ->
    exists xs : seq R, [/\ sorted <%R xs, size xs = (size l).+1 & forall x, x \in xs -> M x /\ (a = 0%N \/ t a < x)].
  have [xs [h1 h2 h3]] := G 0%N (or_introl erefl) pl; exists xs; split=> // x /h3[] //.
elim: l H a {pl} => [|b l IH] H a ha.
  rewrite /= andbT => /andP[ak lt].
  have [|x [h1 _ h2 _]] := peak _ lt ha (or_introl erefl); first by rewrite leqnn ltnW.
  by exists [:: x]; split=> // y; rewrite inE => /eqP ->.
rewrite rcons_cons /= => /andP[/andP[ab lt] pb]; have [dn dp] := H b (mem_head _ _).
have bk : (b < k.+1)%N.
  have tr : transitive (fun a b => (a < b)%N && (t a < t b)).
    by move=> y x z /andP[p1 p2] /andP[q1 q2]; rewrite (ltn_trans p1 q1) (lt_trans p2 q2).
  by have /allP h := order_path_min tr pb; have := h k.+1; rewrite mem_rcons mem_head => /(_ isT) /andP[].
have [|x [h1 /andP[_ x1] h2 h3]] := peak _ lt ha (or_intror dn); first by rewrite (ltnW ab) (ltnW bk).
have {h3} xb : x < t b by case: h3 => // e; rewrite e ltnn in bk.
have [xs [s1 s2 s3]] := IH (fun c hc => H c ltac:(by rewrite inE hc orbT)) b (or_intror dp) pb.
have b0 : b <> 0%N by move=> e; rewrite e in ab.
exists (x :: xs); split; rewrite /= ?s2 //.
  rewrite lt_path_sortedE s1 andbT; apply/allP => y /s3[_ [//|]]; exact: lt_trans.
move=> y; rewrite inE => /orP[/eqP ->|/s3[My [//|by_]]]; split=> //.
by case: h2 => [->|ax]; [left|right; exact: lt_trans by_].
Qed.
End Signs.

(* X.maxima.most for k = 3, and two local maxima for every k >= 3: knots on which G_0^k has two local maxima on the closure of its support *)
Theorem X_maxima_two (R : rcfType) (r : R) k : 0 < r -> r != 1 -> (3 <= k)%N -> exists (t : nat -> R) (l : seq R),
  [/\ forall i, t i <= t i.+1, t 0%N < t k.+1, forall y, t 0%N < y < t k.+1 -> (mult t k.+1 y <= k)%N &
   [/\ sorted <%R l, size l = 2%N & forall x, x \in l -> local_max (value r t k.+1 k 0) (t 0%N) (t k.+1) x]].
Proof.
move=> r0 r1 k3; have [t [x1 [x2 /= [tm U hm [a b c e H]]]]] := Conj3_1_weak_continuous_printed_false r0 r1 k3.
exists t, [:: x1; x2]; split=> //; split=> //; first by rewrite /= b.
move=> x; rewrite !inE => /orP[/eqP ->|/eqP ->]; split.
- by rewrite a ltW // (lt_le_trans b).
- by exists 1 => //; exact: ltr01.
- by rewrite c (le_trans a) // ltW.
by exists 1; [exact: ltr01|move=> y _ _; rewrite -e].
Qed.
