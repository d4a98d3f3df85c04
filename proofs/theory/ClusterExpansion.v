(* The chances of ClusterRace.v up to the third order in h, where the outer lengths are 1 + u h and those of the cluster a h.
   "soon p": p holds of all small h > 0; "O n f": |f(h)| <= C h^n soon; "T2 g s q": g = 1 + s h + (s^2 - q)/2 h^2 up to the third order,
   so that s and q add up in products. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Tower ClusterRace.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Small.
Variable R : realFieldType.
Implicit Types (f g : R -> R) (p : R -> Prop).
Definition soon p := exists2 d, 0 < d & forall h, 0 < h < d -> p h.
Lemma soon_and p p' : soon p -> soon p' -> soon (fun h => p h /\ p' h).
Proof.
move=> [d d0 H] [d' d0' H']; exists (Num.min d d'); first by rewrite lt_minr d0.
by move=> h /andP[h0]; rewrite lt_minr => /andP[h1 h2]; split; [apply: H|apply: H']; rewrite h0.
Qed.
Lemma soon_imp p p' : (forall h, 0 < h -> p h -> p' h) -> soon p -> soon p'.
Proof. by move=> i [d d0 H]; exists d => // h hh; apply: i; [case/andP: hh|apply: H]. Qed.
Lemma soon_all n (p : nat -> R -> Prop) : (forall l, (l < n)%N -> soon (p l)) -> soon (fun h => forall l, (l < n)%N -> p l h).
Proof.
elim: n => [|n IH] H; first by exists 1; first exact: ltr01.
have H1 := IH (fun l hl => H l (leqW hl)); apply: soon_imp (soon_and H1 (H n (ltnSn n))) => h _ [a b] l.
by rewrite ltnS leq_eqVlt => /orP[/eqP ->|]; [exact: b|exact: a].
Qed.
(* a linear function that begins positive is positive soon *)
Lemma soon_lin c u : 0 < c -> soon (fun h => 0 < c + u * h).
Proof.
move=> c0; have n0 : 0 < `|u| + 1 by rewrite ltr_paddl ?ltr01.
exists (c / (`|u| + 1)); first by rewrite divr_gt0.
move=> h /andP[h0]; rewrite ltr_pdivl_mulr // => h1.
rewrite -ltr_subl_addl sub0r; apply: (@lt_le_trans _ _ (- `|u * h|)); last by rewrite ler_oppl -normrN ler_norm.
rewrite ltr_opp2 normrM (gtr0_norm h0) (le_lt_trans _ h1) // mulrC ler_wpmul2l ?(ltW h0) // ler_addl ltW //; exact: ltr01.
Qed.
Lemma soon_lins (us : seq R) : soon (fun h => forall v, v \in us -> 0 < 1 + v * h).
Proof.
elim: us => [|u us IH]; first by exists 1; first exact: ltr01.
apply: soon_imp (soon_and (soon_lin u ltr01) IH) => h _ [a b] v; rewrite inE => /orP[/eqP -> //|]; exact: b.
Qed.

Definition O n f := exists2 C, 0 <= C & soon (fun h => `|f h| <= C * h ^+ n).
Lemma O_ext n f g : soon (fun h => f h = g h) -> O n f -> O n g.
Proof. by move=> e [C C0 H]; exists C => //; apply: soon_imp (soon_and e H) => h _ [<-]. Qed.
Lemma O_add n f g : O n f -> O n g -> O n (fun h => f h + g h).
Proof.
move=> [C C0 H] [C' C0' H']; exists (C + C'); first exact: addr_ge0.
by apply: soon_imp (soon_and H H') => h _ [a b]; rewrite mulrDl (le_trans (ler_norm_add _ _)) // ler_add.
Qed.
Lemma O_mul n m f g : O n f -> O m g -> O (n + m) (fun h => f h * g h).
Proof.
move=> [C C0 H] [C' C0' H']; exists (C * C'); first exact: mulr_ge0.
apply: soon_imp (soon_and H H') => h h0 [a b]; rewrite normrM exprD.
have -> : C * C' * (h ^+ n * h ^+ m) = (C * h ^+ n) * (C' * h ^+ m) by move: (h ^+ n) (h ^+ m) => x y; ring.
exact: ler_pmul.
Qed.
Lemma O_const c : O 0 (fun _ => c).
Proof. by exists `|c|; [exact: normr_ge0|exists 1; [exact: ltr01|move=> h _; rewrite expr0 mulr1]]. Qed.
Lemma O_h n : O n (fun h => h ^+ n).
Proof. by exists 1; [exact: ler01|exists 1; [exact: ltr01|move=> h /andP[h0 _]; rewrite mul1r gtr0_norm // exprn_gt0]]. Qed.
Lemma O_scale n c f : O n f -> O n (fun h => c * f h).
Proof. exact: (O_mul (O_const c)). Qed.
Lemma O_opp n f : O n f -> O n (fun h => - f h).
Proof. by move=> /(O_scale (-1)); apply: O_ext; exists 1; [exact: ltr01|move=> h _; rewrite mulN1r]. Qed.
Lemma O_le n m f : (m <= n)%N -> O n f -> O m f.
Proof.
move=> mn [C C0 H]; exists C => //; have h1 : soon (fun h : R => h < 1) by exists 1; [exact: ltr01|move=> h /andP[]].
apply: soon_imp (soon_and H h1) => h h0 [a b]; apply: le_trans a _; apply: ler_wpmul2l => //.
by rewrite -(subnK mn) exprD ler_pimull ?exprn_ge0 ?(ltW h0) // exprn_ile1 // ltW.
Qed.
Lemma O_zero n : O n (fun _ => 0).
Proof. by exists 0 => //; exists 1; [exact: ltr01|move=> h _; rewrite normr0 mul0r]. Qed.
(* a term of the second order decides against the third *)
Lemma O_pos c f : 0 < c -> O 3 (fun h => f h - c * h ^+ 2) -> soon (fun h => 0 < f h).
Proof.
move=> c0 [C C0 H]; apply: soon_imp (soon_and H (soon_lin (- C) c0)) => h h0 [a b].
have : - (C * h ^+ 3) <= f h - c * h ^+ 2 by move: a; rewrite ler_norml => /andP[].
rewrite ler_subr_addr; apply: lt_le_trans.
have -> : - (C * h ^+ 3) + c * h ^+ 2 = h ^+ 2 * (c + - C * h) by ring.
by rewrite mulr_gt0 ?exprn_gt0.
Qed.

Definition T2 g s q := O 3 (fun h => g h - (1 + s * h + (s ^+ 2 - q) / 2%:R * h ^+ 2)).
Lemma T2_ext g g' s s' q q' : T2 g s q -> soon (fun h => g h = g' h) -> s = s' -> q = q' -> T2 g' s' q'.
Proof. by move=> H e <- <-; apply: O_ext H; apply: soon_imp e => h _ ->. Qed.
Lemma O_poly a b c : O 0 (fun h => a + b * h + c * h ^+ 2).
Proof.
apply: O_add; first apply: O_add; first exact: O_const.
  by apply: O_scale; apply: (O_le (leq0n 1)); apply: O_h.
by apply: O_scale; apply: (O_le (leq0n 2)); apply: O_h.
Qed.
Lemma T2_O0 g s q : T2 g s q -> O 0 g.
Proof.
move=> /(O_le (leq0n 3)) H; have := O_add H (O_poly 1 s ((s ^+ 2 - q) / 2%:R)).
by apply: O_ext; exists 1; [exact: ltr01|move=> h _; rewrite subrK].
Qed.
Lemma T2_O1 g s q : T2 g s q -> O 1 (fun h => 1 - g h).
Proof.
move=> /(@O_le 3 1 _ isT)/O_opp H.
have H1 : O 1 (fun h => - ((s + (s ^+ 2 - q) / 2%:R * h + 0 * h ^+ 2) * h)).
  apply: O_opp; exact: (O_mul (O_poly s ((s ^+ 2 - q) / 2%:R) 0) (O_h 1)).
have := O_add H H1; apply: O_ext; exists 1; [exact: ltr01|move=> h _]; ring.
Qed.
Lemma two_neq0 : 2%:R != 0 :> R. Proof. by rewrite pnatr_eq0. Qed.
Lemma T2_mul g g' s s' q q' : T2 g s q -> T2 g' s' q' -> T2 (fun h => g h * g' h) (s + s') (q + q').
Proof.
move=> H H'; pose c := (s ^+ 2 - q) / 2%:R; pose c' := (s' ^+ 2 - q') / 2%:R.
have H1 := O_mul H (T2_O0 H'). have H2 := O_mul (O_poly 1 s c) H'.
have H3 : O 3 (fun h => h ^+ 3 * (s * c' + s' * c + c * c' * h + 0 * h ^+ 2)) by apply: (O_mul (O_h 3)); apply: O_poly.
have := O_add (O_add H1 H2) H3; apply: O_ext; exists 1; first exact: ltr01.
move=> h _; have n2 := two_neq0; rewrite /c /c'; field; rewrite ?n2 //.
Qed.
Lemma T2_one : T2 (fun _ => 1) 0 0.
Proof. apply: O_ext (O_zero 3); exists 1; first exact: ltr01. move=> h _; have n2 := two_neq0; field; rewrite ?n2 //. Qed.
Lemma O_inv c : O 0 (fun h => (1 + c * h)^-1).
Proof.
exists 2%:R; first by rewrite ler0n.
have h2 : 0 < 1 / 2%:R :> R by rewrite divr_gt0 ?ltr01 ?ltr0n.
apply: soon_imp (soon_lin c h2) => h _ a; rewrite expr0 mulr1.
have e : 1 + c * h = 1 / 2%:R + (1 / 2%:R + c * h) by have n2 := two_neq0; field; rewrite ?n2.
have lo : 1 / 2%:R < 1 + c * h by rewrite e ltr_addl.
have p : 0 < 1 + c * h := lt_trans h2 lo.
by rewrite gtr0_norm ?invr_gt0 // -[2%:R]invrK lef_pinv ?posrE ?invr_gt0 ?ltr0n // -div1r ltW.
Qed.
(* what the products are made of *)
Lemma T2_ratio u c : T2 (fun h => (1 + u * h) / (1 + c * h)) (u - c) (u ^+ 2 - c ^+ 2).
Proof.
have H := O_scale (c ^+ 2 * (u - c)) (O_mul (O_h 3) (O_inv c)).
apply: O_ext H; apply: soon_imp (soon_lin c ltr01) => h _ a; have n : 1 + c * h != 0 by rewrite gt_eqF.
have n2 := two_neq0; field; rewrite ?n ?n2 //.
Qed.
Lemma T2_prod u (al : seq R) : T2 (fun h => \prod_(a <- al) ((1 + u * h) / (1 + u * h + h * a)))
  (- \sum_(a <- al) a) (- (2%:R * u * \sum_(a <- al) a) - \sum_(a <- al) a ^+ 2).
Proof.
elim: al => [|a al IH].
  apply: T2_ext T2_one _ _ _; rewrite ?(big_nil, mulr0, oppr0, subr0) //.
  by exists 1; [exact: ltr01|move=> h _; rewrite big_nil].
apply: T2_ext (T2_mul (T2_ratio u (u + a)) IH) _ _ _; rewrite ?(big_cons, big_cons); [|ring|ring].
exists 1; [exact: ltr01|move=> h _]; rewrite big_cons; congr (_ / _ * _); ring.
Qed.
Lemma T2_outer u v : T2 (fun h => 2%:R * ((1 + u * h) / (1 + u * h + (1 + v * h)))) (u - (u + v) / 2%:R) (u ^+ 2 - ((u + v) / 2%:R) ^+ 2).
Proof.
have n2 := two_neq0; apply: T2_ext (T2_ratio u ((u + v) / 2%:R)) _ erefl erefl.
apply: soon_imp (soon_lin ((u + v) / 2%:R) ltr01) => h _ a; have n : 1 + (u + v) / 2%:R * h != 0 by rewrite gt_eqF.
have e : 1 + u * h + (1 + v * h) = 2%:R * (1 + (u + v) / 2%:R * h) by field; rewrite ?n2.
rewrite e; move: (1 + _ * h) n => z n; by field; rewrite ?n ?n2.
Qed.
End Small.

Section Expand.
Variable R : realFieldType.
Implicit Types us al be : seq R.
Definition lin us (h : R) := [seq 1 + v * h | v <- us].
Definition scaled al (h : R) := [seq h * a | a <- al].
Lemma sides_soon us al vs be : sides al be -> soon (fun h => sides (lin us h ++ scaled al h) (lin vs h ++ scaled be h)).
Proof.
move=> /andP[/andP[ha hb] hab]; apply: soon_imp (soon_and (soon_lins us) (soon_lins vs)) => h h0 [Hu Hv].
have pos us' al' : (forall v, v \in us' -> 0 < 1 + v * h) -> all (fun a => 0 <= a) al' ->
    forall x, x \in lin us' h ++ scaled al' h -> 0 < x \/ exists2 a, a \in al' & x = h * a /\ 0 <= x.
  move=> H Ha x; rewrite mem_cat => /orP[/mapP[v hv ->]|/mapP[a ya ->]]; first by left; apply: H.
  by right; exists a => //; split=> //; rewrite mulr_ge0 ?(ltW h0) // (allP Ha).
have ge us' al' (H : forall v, v \in us' -> 0 < 1 + v * h) (Ha : all (fun a => 0 <= a) al') x (hx : x \in lin us' h ++ scaled al' h) : 0 <= x.
  by case: (pos us' al' H Ha x hx) => [/ltW //|[a _ []]].
apply/andP; split; first by apply/andP; split; apply/allP => x; [exact: (ge us al)|exact: (ge vs be)].
apply/allP => x hx; apply/allP => y hy; have x0 := ge _ _ Hu ha x hx; have y0 := ge _ _ Hv hb y hy.
case: (pos _ _ Hu ha x hx) => [x1|[a a1 [-> _]]]; first by rewrite ltr_paddr.
case: (pos _ _ Hv hb y hy) => [y1|[b b1 [-> _]]]; first by rewrite ltr_paddl // mulr_ge0 ?(ltW h0) // (allP ha).
by rewrite -mulrDr mulr_gt0 // (allP (allP hab a a1)).
Qed.
Lemma rest_nil us al u : all (fun a => 0 <= a) al -> soon (fun h => rest (lin us h ++ scaled al h) [::] (1 + u * h) = 0).
Proof.
move=> ha; have h1 : sides al [::] by rewrite /sides ha; apply/allP.
apply: soon_imp (soon_and (sides_soon us [::] h1) (soon_lin u ltr01)) => h h0 [/andP[/andP[H _] _] b].
by apply: rest_right; apply/allP => x hx; rewrite gt_eqF // ltr_paddr // (allP H).
Qed.
Lemma steps u v (b : R) : 0 <= b -> soon (fun h => [/\ 1 + v * h + h * b != 0, 1 + u * h + (1 + v * h) != 0 & 1 + u * h - h * b != 0]).
Proof.
move=> b0; apply: soon_imp (soon_and (soon_and (soon_lin v ltr01) (soon_lin u ltr01)) (soon_lin (u - b) ltr01)) => h h0 [[v1 u1] w1].
split; rewrite gt_eqF //; [by rewrite ltr_paddr // mulr_ge0 // ltW|exact: addr_gt0|].
by have -> : 1 + u * h - h * b = 1 + (u - b) * h by ring.
Qed.
(* what is left out of the product: one order more than there are outer knots on the other side *)
Lemma rest_small us al be u : sides al be -> O (size us).+1 (fun h => rest (lin us h ++ scaled al h) (scaled be h) (1 + u * h)).
Proof.
elim: us al be => [|v us IH] al be.
  rewrite /=; elim: al be => [|a al IH] be.
    move=> _; have := T2_O1 (T2_prod u [seq - b | b <- be]); apply: O_ext; exists 1; first exact: ltr01.
    move=> h _; rewrite rest_left big_map /scaled big_map; congr (1 - _); apply: eq_bigr => b _; by rewrite mulrN.
  elim: be => [|b be IHb] hs; have /andP[/andP[ha hb] _] := hs.
    by apply: O_ext (O_zero R 1); apply: soon_imp (rest_nil [::] u ha) => h _ ->.
  have [ab h1 h2] := sides_cons hs; have b0 : 0 <= b by case/andP: hb. have a0 : 0 <= a by case/andP: ha.
  have := O_add (O_scale (a / (a + b)) (IHb h2)) (O_scale (b / (a + b)) (IH _ h1)).
  apply: O_ext; apply: soon_imp (soon_and (soon_lin u ltr01) (soon_lin (u - b) ltr01)) => h h0 [u1 w1].
  have hn : h != 0 by rewrite gt_eqF. have abn : a + b != 0 by rewrite gt_eqF.
  rewrite /= rest_step; first last.
  - by rewrite gt_eqF //; have -> : 1 + u * h - h * b = 1 + (u - b) * h by ring.
  - by rewrite gt_eqF // ltr_paddr // mulr_ge0 // ltW.
  - by rewrite -mulrDr mulf_neq0.
  have hab : h * a + h * b != 0 by rewrite -mulrDr mulf_neq0.
  congr (_ * _ + _ * _); field; rewrite ?hn ?abn ?hab //.
elim: be => [|b be IHb] hs; have /andP[/andP[ha hb] _] := hs.
  by apply: O_ext (O_zero R _); apply: soon_imp (rest_nil (v :: us) u ha) => h _ ->.
have b0 : 0 <= b by case/andP: hb.
have h2 : sides al be := sides_tail hs.
have H1 := O_mul (T2_O0 (T2_ratio v (v + b))) (IHb h2).
have H2 := O_mul (O_mul (O_scale b (O_h R 1)) (O_inv (v + b))) (IH _ _ hs).
have := O_add H1 H2; apply: O_ext; apply: soon_imp (steps u v b0) => h h0 [n1 n2 n3].
rewrite /= [RHS]rest_step // expr1; congr (_ * _ + _ * _); congr (_ / _); by [ring|rewrite mulrC|ring].
Qed.

(* the two chances of which G_0^k is the difference, in h *)
Variables (v u w : R) (al be : seq R).
Hypothesis hs : sides al be.
Local Notation mu := (\sum_(b <- be) b - \sum_(a <- al) a).
Local Notation Q := (\sum_(b <- be) b ^+ 2 + \sum_(a <- al) a ^+ 2).
Let hs' : sides be al.
Proof.
case/andP: hs => /andP[ha hb] h; apply/andP; split; first by rewrite hb.
by apply/allP => b hb'; apply/allP => a ha'; rewrite addrC (allP (allP h a ha')).
Qed.
Let prodS (l : seq R) c h : \prod_(a <- l) (c / (c + h * a)) = \prod_(m <- scaled l h) (c / (c + m)).
Proof. by rewrite /scaled big_map. Qed.
Definition second (s q : R) := (s ^+ 2 - q) / 2%:R.
Definition near_s := u - v + mu.
Definition near_q := 2%:R * (u ^+ 2 - ((u + v) / 2%:R) ^+ 2) + 2%:R * u * mu - Q.
Definition far_s := (v - (v + w) / 2%:R) + (v - (v + u) / 2%:R) - mu.
Definition far_q := (v ^+ 2 - ((v + w) / 2%:R) ^+ 2) + (v ^+ 2 - ((v + u) / 2%:R) ^+ 2) - 2%:R * v * mu - Q.
Let sumN (l : seq R) : \sum_(b <- [seq - b | b <- l]) b = - \sum_(b <- l) b.
Proof. by rewrite big_map sumrN. Qed.
Let sumN2 (l : seq R) : \sum_(b <- [seq - b | b <- l]) b ^+ 2 = \sum_(b <- l) b ^+ 2.
Proof. by rewrite big_map; apply: eq_bigr => b _; rewrite sqrrN. Qed.
Let prodN (l : seq R) c h : \prod_(b <- [seq - b | b <- l]) (c / (c + h * b)) = \prod_(m <- scaled l h) (c / (c - m)).
Proof. by rewrite /scaled !big_map; apply: eq_bigr => b _; rewrite mulrN. Qed.
(* the chance without the last knot, and the one without the first *)
Lemma near_chance : O 3 (fun h => cl (lin [:: v; v] h ++ scaled al h) (1 + u * h :: scaled be h) -
  (1 - 4%:R^-1 * (1 + near_s * h + second near_s near_q * h ^+ 2))).
Proof.
have n2 := two_neq0 R. have n4 : 4%:R != 0 :> R by rewrite pnatr_eq0.
have T := T2_mul (T2_mul (T2_outer u v) (T2_outer u v)) (T2_mul (T2_prod u al) (T2_prod u [seq - b | b <- be])).
rewrite !sumN !sumN2 in T.
have {T} T := T2_ext T (s' := near_s) (q' := near_q) (ex_intro2 _ _ 1 ltr01 (fun h _ => erefl)) _ _.
have {T} T : T2 _ near_s near_q := T ltac:(rewrite /near_s; field; rewrite ?n2 //) ltac:(rewrite /near_q; field; rewrite ?n2 //).
have H1 := O_opp (O_add (O_scale (4%:R^-1) T) (@rest_small [:: v; v] al be u hs)).
apply: O_ext H1; apply: soon_imp (soon_and (sides_soon [:: v; v] [::] hs) (soon_lin u ltr01)) => h h0 [S u0].
rewrite (first_last u0 S) /rest /prod !prodN !prodS; move: (cl _ (rcons _ _)) => c; rewrite /= !big_cons.
move: (\prod_(_ <- _) _) (\prod_(_ <- _) _) => X Y; rewrite /second; move: ((1 + u * h) / _) => Z.
by field; rewrite ?n4 ?n2.
Qed.
Lemma far_chance : O 3 (fun h => cl (1 + v * h :: scaled al h) (lin [:: w; u] h ++ scaled be h) -
  4%:R^-1 * (1 + far_s * h + second far_s far_q * h ^+ 2)).
Proof.
have n2 := two_neq0 R. have n4 : 4%:R != 0 :> R by rewrite pnatr_eq0.
have T := T2_mul (T2_mul (T2_outer v w) (T2_outer v u)) (T2_mul (T2_prod v be) (T2_prod v [seq - a | a <- al])).
rewrite !sumN !sumN2 in T.
have {T} T := T2_ext T (s' := far_s) (q' := far_q) (ex_intro2 _ _ 1 ltr01 (fun h _ => erefl)) _ _.
have {T} T : T2 _ far_s far_q := T ltac:(rewrite /far_s; field; rewrite ?n2 //) ltac:(rewrite /far_q; field; rewrite ?n2 //).
have H1 := O_add (O_scale (4%:R^-1) T) (@rest_small [:: w; u] be al v hs').
apply: O_ext H1; apply: soon_imp (soon_and (soon_and (sides_soon [:: w; u] [::] hs') (sides_soon [:: w; u] [:: v] hs')) (soon_lin v ltr01)) => h h0 [[S S'] v0].
rewrite -[1 + v * h :: _]/(lin [:: v] h ++ scaled al h) (cl_swap S') // (first_last v0 S) /rest /prod !prodN !prodS.
move: (cl _ (rcons _ _)) => c; rewrite /= !big_cons.
move: (\prod_(_ <- _) _) (\prod_(_ <- _) _) => X Y; rewrite /second.
by move: ((1 + v * h) / _) ((1 + v * h) / _) => Z Z'; field; rewrite ?n4 ?n2.
Qed.
(* the difference, u = w - Y: with m = u - v + mu it depends on the place of the point through m^2 + mu^2 + 2 Q + Y (m + (u + v)/2) *)
Theorem chances_difference : O 3 (fun h =>
  (cl (lin [:: v; v] h ++ scaled al h) (1 + u * h :: scaled be h) - cl (1 + v * h :: scaled al h) (lin [:: w; u] h ++ scaled be h)) -
  (2%:R^-1 + (w - u) / 8%:R * h - ((u - v + mu) ^+ 2 + mu ^+ 2 + 2%:R * Q + (w - u) * (u - v + mu + (u + v) / 2%:R) + (w - u) ^+ 2 / 2%:R) / 8%:R * h ^+ 2)).
Proof.
have H := O_add near_chance (O_opp far_chance); apply: O_ext H; exists 1; [exact: ltr01|move=> h _].
rewrite /second /near_s /near_q /far_s /far_q.
move: (cl _ _) (cl _ _) (\sum_(_ <- _) _) (\sum_(_ <- _) _) (\sum_(_ <- _) _) (\sum_(_ <- _) _) => c c' s1 s2 s3 s4.
have n2 := two_neq0 R. have n8 : 8%:R != 0 :> R by rewrite pnatr_eq0. have n4 : 4%:R != 0 :> R by rewrite pnatr_eq0.
by field; rewrite ?n2 ?n4 ?n8.
Qed.
End Expand.
