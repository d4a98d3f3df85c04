(* A first-order sentence about one number x of a real closed field, true at a and false at b, changes its truth somewhere between: there is
   a point as close to which as one likes are both numbers for which it is true and for which it is false. By quantifier elimination its truth is
   decided by the signs of finitely many polynomials in x. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import polyrcf ordered_qelim qe_rcf.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Definable.
Variable R : rcfType.
(* terms without division are polynomials in their one variable *)
Lemma rterm_poly (t : GRing.term R) : GRing.rterm t -> exists p : {poly R}, forall x, GRing.eval [:: x] t = p.[x].
Proof.
elim: t => //=.
- move=> [|n] _; first by exists 'X => x; rewrite hornerX.
  by exists 0 => x; rewrite horner0 nth_default.
- by move=> c _; exists c%:P => x; rewrite hornerC.
- by move=> n _; exists n%:R%:P => x; rewrite hornerC.
- move=> t1 IH1 t2 IH2 /andP[/IH1[p hp] /IH2[q hq]]; exists (p + q) => x; by rewrite hornerD hp hq.
- by move=> t IH /IH[p hp]; exists (- p) => x; rewrite hornerN hp.
- by move=> t IH n /IH[p hp]; exists (p *+ n) => x; rewrite hornerMn hp.
- by move=> t1 IH1 t2 IH2 /andP[/IH1[p hp] /IH2[q hq]]; exists (p * q) => x; rewrite hornerM hp hq.
by move=> t IH n /IH[p hp]; exists (p ^+ n) => x; rewrite horner_exp hp.
Qed.
Definition steady (S : R -> bool) := exists2 p : {poly R}, p != 0 & forall x y, x < y -> (forall z, x <= z <= y -> p.[z] != 0) -> S x = S y.
Lemma steady_sign (S : R -> bool) (p : {poly R}) (g : R -> bool) : (forall x, S x = g (Num.sg p.[x])) -> steady S.
Proof.
move=> h; case: (eqVneq p 0) => [e|p0].
  by exists 1; [exact: oner_neq0|move=> x y _ _; rewrite !h e !horner0].
exists p => // x y xy H; rewrite !h; congr g; apply/eqP; apply/negPn/negP => ne.
have [|z] := @ivt_sign R p x y (ltW xy); last first.
  rewrite in_itv /= rootE => /andP[z1 z2] rz; have := H z; by rewrite rz !ltW // => /(_ isT).
have nx : p.[x] != 0 by apply: H; rewrite lexx ltW. have ny : p.[y] != 0 by apply: H; rewrite lexx andbT ltW.
move: ne nx ny; case: (sgrP p.[x]) => [//|hx|hx]; case: (sgrP p.[y]) => [//|hy|hy]; rewrite ?eqxx // => _ _ _.
  by rewrite mul1r.
by rewrite mulr1.
Qed.
Lemma steady_comb (S S' : R -> bool) (g : bool -> bool -> bool) : steady S -> steady S' -> steady (fun x => g (S x) (S' x)).
Proof.
move=> [p p0 hp] [q q0 hq]; exists (p * q); first by rewrite mulf_neq0.
move=> x y xy H; have H' z : x <= z <= y -> (p.[z] != 0) && (q.[z] != 0).
  by move=> /H; rewrite hornerM mulf_eq0 negb_or.
by rewrite (hp x y xy) ?(hq x y xy) // => z /H' /andP[].
Qed.
Lemma steady_const b : steady (fun _ => b).
Proof. by exists 1; first exact: oner_neq0. Qed.
(* the truth of a formula without quantifiers and division changes at roots of a polynomial only *)
Lemma qf_steady (f : ord.formula R) : ord.qf_form f -> ord.rformula f -> steady (fun x => ord.qf_eval [:: x] f).
Proof.
elim: f => //=.
- by move=> b _ _; apply: steady_const.
- move=> t1 t2 _ /andP[/rterm_poly[p hp] /rterm_poly[q hq]].
  by apply: (@steady_sign _ (p - q) (fun s => s == 0)) => x; rewrite hp hq hornerD hornerN sgr_eq0 subr_eq0.
- move=> t1 t2 _ /andP[/rterm_poly[p hp] /rterm_poly[q hq]].
  by apply: (@steady_sign _ (p - q) (fun s => s < 0)) => x; rewrite hp hq hornerD hornerN sgr_lt0 subr_lt0.
- move=> t1 t2 _ /andP[/rterm_poly[p hp] /rterm_poly[q hq]].
  by apply: (@steady_sign _ (p - q) (fun s => s <= 0)) => x; rewrite hp hq hornerD hornerN sgr_le0 subr_le0.
- by move=> f1 IH1 f2 IH2 /andP[/IH1 a /IH2 b] /andP[/a c /b d]; apply: (steady_comb andb).
- by move=> f1 IH1 f2 IH2 /andP[/IH1 a /IH2 b] /andP[/a c /b d]; apply: (steady_comb orb).
- by move=> f1 IH1 f2 IH2 /andP[/IH1 a /IH2 b] /andP[/a c /b d]; apply: (steady_comb implb).
by move=> f IH /IH a /a c; apply: (steady_comb (fun b _ => ~~ b) c (steady_const true)).
Qed.
Definition boundary (S : R -> bool) a b c := a <= c <= b /\ forall e, 0 < e ->
  exists x y, [/\ a <= x <= b, a <= y <= b, `|x - c| < e, `|y - c| < e & S x /\ ~~ S y].
Lemma boundary_chain (S : R -> bool) a l : path <%R a l -> S a -> ~~ S (last a l) ->
  (forall x y, a < x -> x < y -> y < last a l -> (forall w, w \in l -> ~~ (x <= w <= y)) -> S x = S y) ->
  exists c, boundary S a (last a l) c.
Proof.
elim: l a => [|c l IH] a /=; first by move=> _ ->.
move=> /andP[ac pl] Sa Sl H.
have cl : c <= last c l.
  by case: (l) pl => // c' l' pl; apply: ltW; have /allP := order_path_min lt_trans pl; apply; rewrite /= mem_last.
have lt w : w \in l -> c < w by move=> wl; have /allP := order_path_min lt_trans pl; apply.
have gap x y : a < x -> x < y -> y < c -> S x = S y.
  move=> ax xy yc; apply: H => //; first exact: lt_le_trans cl.
  move=> w; rewrite inE => /orP[/eqP ->|/lt h]; first by rewrite [c <= y]leNgt yc andbF.
  by rewrite [w <= y]leNgt (lt_trans yc h) andbF.
have [al la] : a <= last c l /\ a < last c l by split; [apply: le_trans cl; exact: ltW|exact: lt_le_trans cl].
pose mid := (a + c) / 2%:R; have /andP[m1 m2] : a < mid < c by rewrite !midf_lt.
(* points of the gap as close to either end as one likes *)
have near_a e : 0 < e -> exists2 x, a < x < c & `|x - a| < e.
  move=> e0; have : a < Num.min (a + e) c by rewrite lt_minr ac ltr_addl e0.
  move=> /midf_lt[h1]; rewrite lt_minr => /andP[h2 h3]; exists ((a + Num.min (a + e) c) / 2%:R); first by rewrite h1.
  by rewrite gtr0_norm ?subr_gt0 // ltr_subl_addl.
have near_c e : 0 < e -> exists2 x, a < x < c & `|x - c| < e.
  move=> e0; have : Num.max (c - e) a < c by rewrite lt_maxl ac ltr_subl_addr ltr_addl e0.
  move=> /midf_lt[]; rewrite lt_maxl => /andP[h2 h3] h1; exists ((Num.max (c - e) a + c) / 2%:R); first by rewrite h1 h3.
  by rewrite ltr0_norm ?subr_lt0 // opprB ltr_subl_addr -ltr_subl_addl.
have same x : a < x < c -> S x = S mid.
  move=> /andP[x1 x2]; case: (ltgtP x mid) => [h|h|->//]; first exact: gap.
  by symmetry; apply: gap.
have inn x : a < x < c -> a <= x <= last c l.
  by move=> /andP[x1 x2]; rewrite (ltW x1) (le_trans (ltW x2)).
case Sm: (S mid); last first.
  exists a; split=> [|e e0]; first by rewrite lexx.
  have [x hx xe] := near_a e e0; exists a, x; split; rewrite ?lexx ?al ?inn ?subrr ?normr0 //; by rewrite (same x hx) Sm.
case Sc: (S c); last first.
  exists c; split=> [|e e0]; first by rewrite (ltW ac).
  have [x hx xe] := near_c e e0; exists x, c; split; [exact: inn|by rewrite (ltW ac)|exact: xe|by rewrite subrr normr0|by rewrite (same x hx) Sm Sc].
have [x y cx xy yl h|c' [/andP[h1 h2] h]] := IH c pl Sc Sl.
  apply: H => //; first exact: lt_trans cx.
  by move=> w; rewrite inE => /orP[/eqP ->|]; [rewrite leNgt cx|exact: h].
exists c'; split; first by rewrite h2 (le_trans (ltW ac)).
move=> e e0; have [x [y [/andP[x1 x2] /andP[y1 y2] xc yc hS]]] := h e e0.
by exists x, y; split; rewrite ?x2 ?y2 // ?(le_trans (ltW ac)).
Qed.
Lemma steady_boundary (S : R -> bool) a b : a < b -> steady S -> S a -> ~~ S b -> exists c, boundary S a b c.
Proof.
move=> ab [p p0 hp] Sa Sb; have hr := @roots_on_roots R p a b p0.
have s1 : sorted <%R (roots p a b) by exact: sorted_roots.
pose l := rcons (roots p a b) b; have E : last a l = b by rewrite last_rcons.
have in_ w : w \in roots p a b -> a < w < b by rewrite -hr in_itv => /andP[].
rewrite -E; apply: boundary_chain; rewrite ?E //.
  rewrite rcons_path; apply/andP; split.
    by rewrite lt_path_sortedE s1 andbT; apply/allP => w /in_ /andP[].
  have := mem_last a (roots p a b); rewrite inE => /orP[/eqP ->//|/in_ /andP[] //].
move=> x y ax xy yb H; apply: hp => // z /andP[z1 z2]; apply/negP => rz.
have zr : z \in roots p a b.
  by rewrite -hr in_itv /= (lt_le_trans ax z1) (le_lt_trans z2 yb) rootE.
by have := H z; rewrite mem_rcons inE zr orbT z1 z2 => /(_ isT).
Qed.
(* a sentence about x that is true at a and false at b changes its truth somewhere between *)
Theorem definable_boundary (f : ord.formula R) (P : R -> Prop) a b : (forall x, P x <-> ord.holds [:: x] f) -> a < b -> P a -> ~ P b ->
  exists c, a <= c <= b /\ forall e, 0 < e -> exists x y, [/\ a <= x <= b, a <= y <= b, `|x - c| < e, `|y - c| < e & P x /\ ~ P y].
Proof.
move=> h ab Pa Pb; pose S x := rcf_sat [:: x] f.
have SP x : P x <-> S x by split=> [/h|] s; [apply/rcf_satP|apply/h/rcf_satP].
have st : steady S.
  have /andP[q r] := ord.quantifier_elim_wf (@wf_QE_wproj R) (ord.to_rform_rformula f); exact: qf_steady.
have [c [hc H]] := steady_boundary ab st (proj1 (SP a) Pa) (introN idP (fun s => Pb (proj2 (SP b) s))).
exists c; split=> // e /H[x [y [hx hy xe ye [Sx Sy]]]]; exists x, y; split=> //; split; first exact/SP.
by move=> /SP; apply/negP.
Qed.
End Definable.
