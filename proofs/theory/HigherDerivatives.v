(* Derivatives of every order from the left and from the right, and orders of vanishing. A function that is a quotient of
   polynomials on one side of y, without a pole at y, has derivatives of every order there, and their limits at y are the values
   of the quotient's. Two such quotients whose difference has the factor (x - y)^M have the same derivatives of order below M. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From Bsplines Require Import Definitions Derivatives RationalDerivative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Near.
Variable R : realFieldType.
Implicit Types (P Q S : {poly R}) (u v y d : R).
Lemma poly_bnd P y : bnd (fun h => P.[y + h]).
Proof.
elim/poly_ind: P => [|P c IH].
  have [C [d [c0 d0 h]]] := bnd_const (0 : R); exists C, d; split => // z hz; rewrite horner0; exact: h hz.
have B : bnd (fun h => P.[y + h] * (y + h) + c).
  by apply: bnd_add (bnd_const c); apply: bnd_mul IH _; apply: bnd_add (bnd_const y) (@bnd_id R).
have [C [d [c0 d0 h]]] := B; exists C, d; split => // z hz; rewrite hornerMXaddC; exact: h hz.
Qed.
Lemma poly_first P y : exists S, forall h, P.[y + h] = P.[y] + h * S.[y + h].
Proof.
have r0 : root (P - P.[y]%:P) y by rewrite rootE !hE subrr.
have [S e] := factor_theorem _ _ r0.
exists S => h; have := congr1 (fun p => p.[y + h]) e; rewrite /= hornerM hornerXsubC !hE.
by rewrite [y + h - y]addrC addKr mulrC => <-; rewrite [RHS]addrC subrK.
Qed.
(* near a point where it is not 0 a polynomial is not 0, and its inverse is bounded *)
Lemma poly_near Q y : Q.[y] != 0 -> exists2 d, 0 < d & forall h, `|h| < d -> `|Q.[y]| / 2%:R <= `|Q.[y + h]|.
Proof.
move=> n; have [S e] := poly_first Q y; have [C [d [C0 d0 hC]]] := poly_bnd S y.
have n0 : 0 < `|Q.[y]| by rewrite normr_gt0.
have C1 : 0 < C + 1 by rewrite ltr_paddl ?ltr01.
exists (Num.min d (`|Q.[y]| / 2%:R / (C + 1))).
  by rewrite lt_minr d0 !divr_gt0 // ltr0n.
move=> h; rewrite lt_minr => /andP[h1 h2]; rewrite e.
have := ler_sub_dist Q.[y] (- (h * S.[y + h])); rewrite opprK; apply: le_trans.
rewrite normrN ler_subr_addr -ler_subr_addl.
have -> : `|Q.[y]| - `|Q.[y]| / 2%:R = `|Q.[y]| / 2%:R by field.
rewrite normrM; apply: (@le_trans _ _ (`|h| * (C + 1))).
  by rewrite ler_wpmul2l ?normr_ge0 // (le_trans (hC _ h1)) // ler_addl ler01.
by rewrite -ler_pdivl_mulr // ltW.
Qed.
Lemma poly_near0 Q y : Q.[y] != 0 -> exists2 d, 0 < d & forall x, y - d < x < y + d -> Q.[x] != 0.
Proof.
move=> n; have [d d0 h] := poly_near n; exists d => // x /andP[x1 x2].
have e : x = y + (x - y) by rewrite addrC subrK.
have := h (x - y); rewrite -e ltr_norml ltr_subr_addl x1 ltr_subl_addl x2 => /(_ isT) h'.
by rewrite -normr_gt0; apply: lt_le_trans h'; rewrite divr_gt0 ?normr_gt0 ?ltr0n.
Qed.
Lemma inv_bnd Q y : Q.[y] != 0 -> bnd (fun h => (Q.[y + h])^-1).
Proof.
move=> n; have [d d0 h] := poly_near n; have n0 : 0 < `|Q.[y]| / 2%:R by rewrite divr_gt0 ?normr_gt0 ?ltr0n.
exists (`|Q.[y]| / 2%:R)^-1, d; split; rewrite ?invr_ge0 ?(ltW n0) // => z hz.
have hz' := h z hz; rewrite normfV lef_pinv ?posrE //; exact: lt_le_trans hz'.
Qed.

(* a chain on (u,v): each function is the derivative of the one before *)
Definition chain (u v : R) (q : nat) (F : nat -> R -> R) := forall j, (j < q)%N -> isd u v (F j) (F j.+1).
Lemma chain_uniq u v q F H : chain u v q F -> chain u v q H -> (forall x, u < x < v -> F 0%N x = H 0%N x) ->
  forall j x, (j <= q)%N -> u < x < v -> F j x = H j x.
Proof.
move=> cF cH e; elim=> [|j IH] x jq hx; first exact: e.
by apply: (isd_uniq (cF j jq) (cH j jq)) => // z hz; apply: IH => //; exact: ltnW.
Qed.
Lemma isd_sub_itv (u v u' v' : R) f f' : u <= u' -> v' <= v -> isd u v f f' -> isd u' v' f f'.
Proof.
by move=> hu hv [P [Q h]]; exists P, Q => x /andP[x1 x2]; apply: h; rewrite (le_lt_trans hu) // (lt_le_trans x2).
Qed.
(* the quotient's derivatives *)
Definition Dq P Q (q : nat) (x : R) : R := (quotients P Q q).1.[x] / (quotients P Q q).2.[x].
Lemma Dq_den P Q q x : Q.[x] != 0 -> (quotients P Q q).2.[x] != 0.
Proof. by move=> n; elim: q => [|q IH] //=; rewrite horner_exp expf_neq0. Qed.
Lemma Dq_isd P Q u v q : (forall x, u < x < v -> Q.[x] != 0) -> isd u v (Dq P Q q) (Dq P Q q.+1).
Proof.
move=> n; exists (quotients P Q q).1, (quotients P Q q).2 => x hx; split => //; first exact/Dq_den/n.
by rewrite /Dq /= horner_exp !hE.
Qed.
Lemma Dq_chain P Q u v q : (forall x, u < x < v -> Q.[x] != 0) -> chain u v q (Dq P Q).
Proof. by move=> n j _; apply: Dq_isd. Qed.
Lemma Dq_taylor P Q y q : Q.[y] != 0 -> taylor (Dq P Q q) y (Dq P Q q y) (Dq P Q q.+1 y).
Proof.
move=> n; have [d d0 hd] := poly_near0 n.
have hy : y - d < y < y + d by rewrite ltr_subl_addr !ltr_addl d0.
have [Q' [n' h']] := isd_taylor (Dq_isd P q hd); have [S hS] := h' y hy.
exists (fun h => S.[y + h] * (Q'.[y + h])^-1), d; split => //.
  by apply: bnd_mul; [exact: poly_bnd|apply: inv_bnd; apply: n'].
move=> h; rewrite ltr_norml => /andP[h1 h2]; rewrite hS; last by rewrite !ltr_add2l h1.
by rewrite [y + h - y]addrC addKr mulrC [_ * h]mulrC mulrC [h ^+ 2 * _]mulrC; congr (_ + _); rewrite mulrC.
Qed.

(* limits in the usual sense *)
Definition limit_at_left (f : R -> R) y v := forall eps, 0 < eps -> exists2 d, 0 < d & forall x, y - d < x < y -> `|f x - v| < eps.
Definition limit_at_right (f : R -> R) y v := forall eps, 0 < eps -> exists2 d, 0 < d & forall x, y < x < y + d -> `|f x - v| < eps.
(* D(f, q)(y-) = v and D(f, q)(y+) = v: near y, on one side, f has derivatives up to order q, and the last of them has the limit v *)
Definition derivative_left q (f : R -> R) y v := exists d F, [/\ 0 < d, forall x, y - d < x < y -> F 0%N x = f x,
  chain (y - d) y q F & limit_at_left (F q) y v].
Definition derivative_right q (f : R -> R) y v := exists d F, [/\ 0 < d, forall x, y < x < y + d -> F 0%N x = f x,
  chain y (y + d) q F & limit_at_right (F q) y v].

Lemma two_values (v v' : R) : (forall eps, 0 < eps -> exists z, `|z - v| < eps /\ `|z - v'| < eps) -> v = v'.
Proof.
move=> H; apply/eqP; rewrite -subr_eq0 -normr_eq0; apply: contraT; rewrite -normr_gt0 normr_id => h.
have [z [h1 h2]] := H (`|v - v'| / 2%:R) ltac:(by rewrite divr_gt0 ?ltr0n).
have : `|v - v'| < `|v - v'|.
  rewrite {1}(_ : v - v' = (z - v') - (z - v)); last by ring.
  apply: le_lt_trans (ler_norm_sub _ _) _; rewrite [X in _ < X](_ : _ = `|v - v'| / 2%:R + `|v - v'| / 2%:R); last by field.
  exact: ltr_add.
by rewrite ltxx.
Qed.
(* there is only one such number *)
Theorem derivative_left_unique q f y v v' : derivative_left q f y v -> derivative_left q f y v' -> v = v'.
Proof.
move=> [d [F [d0 F0 cF lF]]] [d' [H [d0' H0 cH lH]]]; apply: two_values => eps e0.
have [e1 e10 he1] := lF eps e0; have [e2 e20 he2] := lH eps e0.
pose D := Num.min (Num.min d d') (Num.min e1 e2); have D0 : 0 < D by rewrite !lt_minr d0 d0' e10.
have /andP[z1 z2] : y - D < (y - D + y) / 2%:R < y by rewrite !midf_lt // ltr_subl_addr ltr_addl.
move: ((y - D + y) / 2%:R) z1 z2 => z z1 z2; move: (z1); rewrite ltr_subl_addr -ltr_subl_addl !lt_minr => /andP[/andP[a1 a2] /andP[a3 a4]].
have sub c x : y - x < c -> y - c < x by rewrite ltr_subl_addr -ltr_subl_addl.
exists (F q z); split; first by apply: he1; rewrite z2 sub.
have -> : F q z = H q z; last by apply: he2; rewrite z2 sub.
apply: (@chain_uniq (y - Num.min d d') y q F H) => //.
- by move=> j jq; apply: isd_sub_itv (cF j jq) => //; rewrite ler_add2l ler_opp2 le_minl lexx.
- by move=> j jq; apply: isd_sub_itv (cH j jq) => //; rewrite ler_add2l ler_opp2 le_minl lexx orbT.
- move=> x /andP[x1 x2]; move: x1; rewrite ltr_subl_addr -ltr_subl_addl lt_minr => /andP[b1 b2].
  by rewrite F0 ?H0 // x2 sub.
by rewrite z2 andbT; apply: sub; rewrite lt_minr a1.
Qed.
Theorem derivative_right_unique q f y v v' : derivative_right q f y v -> derivative_right q f y v' -> v = v'.
Proof.
move=> [d [F [d0 F0 cF lF]]] [d' [H [d0' H0 cH lH]]]; apply: two_values => eps e0.
have [e1 e10 he1] := lF eps e0; have [e2 e20 he2] := lH eps e0.
pose D := Num.min (Num.min d d') (Num.min e1 e2); have D0 : 0 < D by rewrite !lt_minr d0 d0' e10.
have /andP[z1 z2] : y < (y + (y + D)) / 2%:R < y + D by rewrite !midf_lt // ltr_addl.
move: ((y + (y + D)) / 2%:R) z1 z2 => z z1 z2; move: (z2); rewrite -ltr_subl_addl !lt_minr => /andP[/andP[a1 a2] /andP[a3 a4]].
have sub c x : x - y < c -> x < y + c by rewrite ltr_subl_addl.
exists (F q z); split; first by apply: he1; rewrite z1 sub.
have -> : F q z = H q z; last by apply: he2; rewrite z1 sub.
apply: (@chain_uniq y (y + Num.min d d') q F H) => //.
- by move=> j jq; apply: isd_sub_itv (cF j jq) => //; rewrite ler_add2l le_minl lexx.
- by move=> j jq; apply: isd_sub_itv (cH j jq) => //; rewrite ler_add2l le_minl lexx orbT.
- move=> x /andP[x1 x2]; move: x2; rewrite -ltr_subl_addl lt_minr => /andP[b1 b2].
  by rewrite F0 ?H0 // x1 sub.
by rewrite z1 /= sub // lt_minr a1.
Qed.

Lemma taylor_limits (f : R -> R) y v l : taylor f y v l -> limit_at_left f y v /\ limit_at_right f y v.
Proof.
move=> [g [d [bg d0 hg]]].
have e : f y = v by have := hg 0; rewrite normr0 d0 => /(_ isT); rewrite mulr0 expr0n mul0r !addr0.
have C := @taylor_continuous R f y l l.
have L : left_taylor f y (f y) l.
  exists (fun h => g (- h)), d; split => //.
    by case: bg => K [D [K0 D0 H]]; exists K, D; split => // h hh; apply: H; rewrite normrN.
  by move=> h /andP[h0 h1]; rewrite hg ?normrN ?gtr0_norm // e sqrrN mulrN.
have Q : right_taylor f y (f y) l by exists g, d; split => // h /andP[h0 h1]; rewrite hg ?ger0_norm ?e.
rewrite -e; split=> eps e0; have [D D0 H] := C L Q eps e0; exists D => // x /andP[x1 x2]; apply: H.
  by rewrite ltr_norml ltr_subr_addl x1 /= ltr_subl_addl (lt_trans x2) ?ltr_addl.
by rewrite ltr_norml [x - y < D]ltr_subl_addl x2 andbT ltr_subr_addl (lt_trans _ x1) // ltr_subl_addr ltr_addl.
Qed.
(* a quotient on one side of y, without a pole at y *)
Theorem quotient_left P Q f y d : 0 < d -> Q.[y] != 0 -> (forall x, y - d < x < y -> f x = P.[x] / Q.[x]) ->
  forall q, derivative_left q f y (Dq P Q q y).
Proof.
move=> d0 n e q; have [c c0 hc] := poly_near0 n.
exists (Num.min c d), (Dq P Q); split; first by rewrite lt_minr c0.
- move=> x /andP[x1 x2]; rewrite /Dq /= e // x2 andbT; apply: le_lt_trans x1.
  by rewrite ler_add2l ler_opp2 le_minl lexx orbT.
- apply: Dq_chain => x /andP[x1 x2]; apply: hc; rewrite (lt_trans x2) ?ltr_addl // andbT; apply: le_lt_trans x1.
  by rewrite ler_add2l ler_opp2 le_minl lexx.
by have [] := taylor_limits (Dq_taylor P q n).
Qed.
Theorem quotient_right P Q f y d : 0 < d -> Q.[y] != 0 -> (forall x, y < x < y + d -> f x = P.[x] / Q.[x]) ->
  forall q, derivative_right q f y (Dq P Q q y).
Proof.
move=> d0 n e q; have [c c0 hc] := poly_near0 n.
exists (Num.min c d), (Dq P Q); split; first by rewrite lt_minr c0.
- move=> x /andP[x1 x2]; rewrite /Dq /= e // x1 /=; apply: lt_le_trans x2 _.
  by rewrite ler_add2l le_minl lexx orbT.
- apply: Dq_chain => x /andP[x1 x2]; apply: hc; apply/andP; split.
    by apply: lt_trans x1; rewrite ltr_subl_addr ltr_addl.
  by apply: lt_le_trans x2 _; rewrite ler_add2l le_minl lexx.
by have [] := taylor_limits (Dq_taylor P q n).
Qed.

(* f is (x - y)^M times a quotient without a pole at y that has the value a there; where the quotient's denominator is not 0 *)
Definition leading y M (f : R -> R) (a : R) := exists S Q, [/\ Q.[y] != 0, S.[y] / Q.[y] = a &
  forall x, Q.[x] != 0 -> f x = (x - y) ^+ M * (S.[x] / Q.[x])].
Lemma leading_near W y M f g a : W.[y] != 0 -> (forall x, W.[x] != 0 -> f x = g x) -> leading y M f a -> leading y M g a.
Proof.
move=> nW e [S [Q [n v h]]]; exists (S * W), (Q * W); split; first by rewrite hornerM mulf_neq0.
  by rewrite !hornerM -mulf_div divff // mulr1.
move=> x; rewrite !hornerM mulf_eq0 negb_or => /andP[hx wx]; rewrite -e // h //; congr (_ * _).
by rewrite -mulf_div divff // mulr1.
Qed.
Lemma leading_ext y M f g a : (forall x, f x = g x) -> leading y M f a -> leading y M g a.
Proof. by move=> e; apply: (@leading_near 1) => //; rewrite hornerC oner_neq0. Qed.
Lemma leading_quot y P Q : Q.[y] != 0 -> leading y 0 (fun x => P.[x] / Q.[x]) (P.[y] / Q.[y]).
Proof. by move=> n; exists P, Q; split => // x _; rewrite expr0 mul1r. Qed.
Lemma leading_poly y P : leading y 0 (fun x => P.[x]) P.[y].
Proof. by exists P, 1; split => [||x _]; rewrite ?hornerC ?oner_neq0 ?expr0 ?mul1r ?divr1. Qed.
Lemma leading_const y c : leading y 0 (fun _ => c) c.
Proof. by exists c%:P, 1; split => [||x _]; rewrite ?hornerC ?oner_neq0 ?expr0 ?mul1r ?divr1. Qed.
Lemma leading0 y M : leading y M (fun _ => 0) 0.
Proof. by exists 0, 1; split => [||x _]; rewrite ?horner0 ?hornerC ?oner_neq0 ?mul0r ?mulr0. Qed.
Lemma leading_add y M f g a b : leading y M f a -> leading y M g b -> leading y M (fun x => f x + g x) (a + b).
Proof.
move=> [S [Q [n <- h]]] [S' [Q' [n' <- h']]]; exists (S * Q' + S' * Q), (Q * Q'); split; first by rewrite hornerM mulf_neq0.
  by rewrite !hE addf_div.
move=> x; rewrite hornerM mulf_eq0 negb_or => /andP[hx hx']; rewrite h // h' // !hE -mulrDr; congr (_ * _).
by rewrite addf_div.
Qed.
Lemma leading_mul y M M' f g a b : leading y M f a -> leading y M' g b -> leading y (M + M') (fun x => f x * g x) (a * b).
Proof.
move=> [S [Q [n <- h]]] [S' [Q' [n' <- h']]]; exists (S * S'), (Q * Q'); split; first by rewrite hornerM mulf_neq0.
  by rewrite !hE mulf_div.
move=> x; rewrite hornerM mulf_eq0 negb_or => /andP[hx hx']; rewrite h // h' // !hE exprD -mulf_div; move: (_ ^+ _) (_ ^+ _) (_ / _) (_ / _).
by move=> u v c e; ring.
Qed.
Lemma leading_scale y M f a c : leading y M f a -> leading y M (fun x => c * f x) (c * a).
Proof. exact: leading_mul (leading_const y c). Qed.
Lemma leading_opp y M f a : leading y M f a -> leading y M (fun x => - f x) (- a).
Proof. by move=> h; rewrite -mulN1r; apply: (leading_ext _ (leading_scale (-1) h)) => x; rewrite mulN1r. Qed.
Lemma leading_sub y M f g a b : leading y M f a -> leading y M g b -> leading y M (fun x => f x - g x) (a - b).
Proof. by move=> h h'; apply: leading_add => //; apply: leading_opp. Qed.
Lemma leading_lt y M M' f a : (M' < M)%N -> leading y M f a -> leading y M' f 0.
Proof.
move=> lt [S [Q [n _ h]]]; exists (('X - y%:P) ^+ (M - M') * S), Q; split => //.
  by rewrite hornerM horner_exp hornerXsubC subrr expr0n subn_eq0 leqNgt lt !mul0r.
by move=> x hx; rewrite h // hornerM horner_exp hornerXsubC -{1}(subnKC (ltnW lt)) exprD !mulrA.
Qed.
(* a factor that is not 0 at y can be divided away *)
Lemma leading_div y M D W f g a : D.[y] != 0 -> W.[y] != 0 -> (forall x, W.[x] != 0 -> D.[x] * f x = g x) -> leading y M g a ->
  leading y M f (a / D.[y]).
Proof.
move=> nD nW e [S [Q [n <- h]]]; exists (S * W), (Q * D * W); split; first by rewrite !hornerM !mulf_neq0.
  rewrite !hornerM; move: nD nW n; move: Q.[y] D.[y] W.[y] S.[y] => q b c u nb nc nq; by field; rewrite nb nc nq.
move=> x; rewrite !hornerM !mulf_eq0 !negb_or => /andP[/andP[q dx] wx].
apply: (mulfI dx); rewrite e // h // [RHS]mulrCA; congr (_ * _); move: q dx wx; move: Q.[x] D.[x] W.[x] S.[x] => b c u v q dx wx.
by field; rewrite q dx wx.
Qed.

(* the derivatives of (x-y)^M S/Q: those of order below M are 0 at y, and that of order M is M! S(y)/Q(y) *)
Fixpoint factored y (M : nat) S Q (q : nat) : {poly R} * {poly R} := if q is q'.+1 then let SQ := factored y M S Q q' in
  ((M - q')%N%:R *: (SQ.1 * SQ.2) + ('X - y%:P) * (SQ.1^`() * SQ.2 - SQ.1 * SQ.2^`()), SQ.2 ^+ 2) else (S, Q).
Lemma isd_power u v y M : isd u v (fun x => (x - y) ^+ M.+1) (fun x => M.+1%:R * (x - y) ^+ M).
Proof.
have s1 : isd u v (fun x => x - y) (fun _ => 1 - 0) := isd_sub (isd_id u v) (isd_const u v y).
elim: M => [|M IH].
  by apply: (isd_ext s1) => x _; rewrite ?expr1 // expr0 mulr1 subr0.
apply: (isd_ext (isd_mul s1 IH)) => x _; rewrite ?exprS // -[M.+2]addn1 natrD; move: ((x - y) ^+ M) => a; ring.
Qed.
Lemma isd_quot u v P Q : (forall x, u < x < v -> Q.[x] != 0) ->
  isd u v (fun x => P.[x] / Q.[x]) (fun x => (P^`().[x] * Q.[x] - P.[x] * Q^`().[x]) / Q.[x] ^+ 2).
Proof. by move=> n; exists P, Q => x hx; split => //; apply: n. Qed.
Lemma factored_den y M S Q q x : Q.[x] != 0 -> (factored y M S Q q).2.[x] != 0.
Proof. by move=> n; elim: q => [|q IH] //=; rewrite horner_exp expf_neq0. Qed.
Definition Vq y M S Q q x := (x - y) ^+ (M - q) * ((factored y M S Q q).1.[x] / (factored y M S Q q).2.[x]).
Lemma Vq_chain u v y M S Q : (forall x, u < x < v -> Q.[x] != 0) -> chain u v M (Vq y M S Q).
Proof.
move=> n q qM; rewrite /Vq; have E : (M - q = (M - q.+1).+1)%N by rewrite subnSK.
have nq x : u < x < v -> (factored y M S Q q).2.[x] != 0 by move=> hx; apply/factored_den/n.
rewrite {1}E; apply: (isd_ext (isd_mul (isd_power u v y (M - q.+1)) (isd_quot (factored y M S Q q).1 nq))) => x hx //.
rewrite /= horner_exp hornerD hornerZ !hornerM hornerXsubC !hE.
have := nq x hx; move: (factored y M S Q q).1.[x] (factored y M S Q q).2.[x] (factored y M S Q q).1^`().[x] (factored y M S Q q).2^`().[x].
move=> a b a' b' nb; have F (e c z : R) : e * ((c * (a * b) + z * (a' * b - a * b')) / b ^+ 2) = c * e * (a / b) + (z * e) * ((a' * b - a * b') / b ^+ 2).
  by field.
by rewrite F -exprS -E.
Qed.
Lemma factored_y y M S Q q : Q.[y] != 0 -> (q <= M)%N ->
  (factored y M S Q q).1.[y] / (factored y M S Q q).2.[y] = (M ^_ q)%:R * (S.[y] / Q.[y]).
Proof.
move=> n; elim: q => [|q IH] qM; first by rewrite ffactn0 mul1r.
rewrite /= horner_exp hornerD hornerZ !hornerM hornerXsubC subrr mul0r addr0 ffactnSr natrM.
have := factored_den y M S q n; have := IH (ltnW qM).
move: (factored y M S Q q).1.[y] (factored y M S Q q).2.[y] (S.[y] / Q.[y]) => a b c e nb.
by rewrite [RHS]mulrAC -e; move: ((M - q)%:R : R) => z; field.
Qed.

(* two quotients whose difference has the factor (x - y)^M: the same derivatives of order below M; those of order M differ by M! a *)
Theorem leading_jump y M P1 Q1 P2 Q2 a : Q1.[y] != 0 -> Q2.[y] != 0 ->
  leading y M (fun x => P2.[x] / Q2.[x] - P1.[x] / Q1.[x]) a ->
  (forall q, (q < M)%N -> Dq P1 Q1 q y = Dq P2 Q2 q y) /\ Dq P2 Q2 M y - Dq P1 Q1 M y = M`!%:R * a.
Proof.
move=> n1 n2 [S [Q [n v h]]]; have nn : (Q * (Q1 * Q2)).[y] != 0 by rewrite !hornerM !mulf_neq0.
have [d d0 hd] := poly_near0 nn.
have hz x : y - d < x < y + d -> [/\ Q.[x] != 0, Q1.[x] != 0 & Q2.[x] != 0].
  by move/hd; rewrite !hornerM !mulf_eq0 !negb_or => /andP[-> /andP[-> ->]].
have hy : y - d < y < y + d by rewrite ltr_subl_addr !ltr_addl d0.
have c1 : chain (y - d) (y + d) M (Dq P1 Q1) by apply: Dq_chain => x /hz[].
have c2 : chain (y - d) (y + d) M (Dq P2 Q2) by apply: Dq_chain => x /hz[].
have c3 : chain (y - d) (y + d) M (Vq y M S Q) by apply: Vq_chain => x /hz[].
have c4 : chain (y - d) (y + d) M (fun q x => Dq P2 Q2 q x - Dq P1 Q1 q x) by move=> j jM; apply: isd_sub; [apply: c2|apply: c1].
have E q : (q <= M)%N -> Dq P2 Q2 q y - Dq P1 Q1 q y = Vq y M S Q q y.
  move=> qM; apply: (chain_uniq c4 c3 _ qM hy).
  by move=> x /hz[hx _ _]; rewrite /Dq /Vq /= subn0 h.
split=> [q qM|]; last by rewrite E // /Vq subnn expr0 mul1r factored_y // v ffactnn.
apply/eqP; rewrite eq_sym -subr_eq0; apply/eqP; rewrite (E q (ltnW qM)).
by rewrite /Vq subrr -(prednK (_ : 0 < M - q)%N) ?subn_gt0 // exprS mul0r mul0r.
Qed.

Lemma derivative_left_ext q f g y v c : c < y -> (forall x, c < x < y -> f x = g x) -> derivative_left q f y v -> derivative_left q g y v.
Proof.
move=> cy e [d [F [d0 F0 cF lF]]]; exists (Num.min d (y - c)), F; split=> //; first by rewrite lt_minr d0 subr_gt0.
  move=> x /andP[x1 x2]; move: x1; rewrite ltr_subl_addr -ltr_subl_addl lt_minr => /andP[a1 a2].
  by rewrite F0 ?e // x2 andbT ?ltr_subl_addr -?ltr_subl_addl //; move: a2; rewrite ltr_add2l ltr_opp2.
by move=> j jq; apply: isd_sub_itv (cF j jq) => //; rewrite ler_add2l ler_opp2 le_minl lexx.
Qed.
Lemma derivative_right_ext q f g y v c : y < c -> (forall x, y < x < c -> f x = g x) -> derivative_right q f y v -> derivative_right q g y v.
Proof.
move=> cy e [d [F [d0 F0 cF lF]]]; exists (Num.min d (c - y)), F; split=> //; first by rewrite lt_minr d0 subr_gt0.
  move=> x /andP[x1 x2]; move: x2; rewrite -ltr_subl_addl lt_minr => /andP[a1 a2].
  by rewrite F0 ?e // x1 /= -?ltr_subl_addl //; move: a2; rewrite ltr_add2r.
by move=> j jq; apply: isd_sub_itv (cF j jq) => //; rewrite ler_add2l le_minl lexx.
Qed.
(* the piece of a span: a quotient without a pole at y, if the weights over the span are *)
Definition quotient_at y (f : R -> R) := exists P Q, Q.[y] != 0 /\ forall x, Q.[x] != 0 -> f x = P.[x] / Q.[x].
Lemma leading_quotient y f a : leading y 0 f a -> quotient_at y f.
Proof. by move=> [P [Q [n _ h]]]; exists P, Q; split => // x hx; rewrite h // expr0 mul1r. Qed.
Lemma quotient_leading y f : quotient_at y f -> exists a, leading y 0 f a.
Proof. by move=> [P [Q [n h]]]; exists (P.[y] / Q.[y]), P, Q; split => // x hx; rewrite h // expr0 mul1r. Qed.
Theorem N_quotient (v : nat -> nat -> R -> R) s k i y :
  (forall e j, (j <= s < j + e)%N -> quotient_at y (v e j)) -> quotient_at y (fun x => N (fun e j => v e j x) s k i).
Proof.
move=> hv; suff [a h] : exists a, leading y 0 (fun x => N (fun e j => v e j x) s k i) a by exact: leading_quotient h.
elim: k i => [|k IH] i; first by exists (i == s)%:R; exact: leading_const.
have [a ha] : exists a, leading y 0 (fun x => v k.+1 i x * N (fun e j => v e j x) s k i) a.
  case: (boolP (i <= s <= i + k)%N) => hi; last first.
    by exists 0; apply: (leading_ext _ (leading0 y 0)) => x; rewrite N_supp // mulr0.
  have [b hb] := quotient_leading (hv k.+1 i ltac:(by rewrite addnS ltnS)); have [c hc] := IH i.
  by exists (b * c); apply: leading_mul hb hc.
have [b hb] : exists a, leading y 0 (fun x => (1 - v k.+1 i.+1 x) * N (fun e j => v e j x) s k i.+1) a.
  case: (boolP (i.+1 <= s <= i.+1 + k)%N) => hi; last first.
    by exists 0; apply: (leading_ext _ (leading0 y 0)) => x; rewrite N_supp // mulr0.
  have [b hb] := quotient_leading (hv k.+1 i.+1 ltac:(by rewrite addnS ltnS)); have [c hc] := IH i.+1.
  by exists ((1 - b) * c); exact: (leading_mul (leading_sub (leading_const y 1) hb) hc).
exists (a + b); exact: leading_add ha hb.
Qed.
End Near.
