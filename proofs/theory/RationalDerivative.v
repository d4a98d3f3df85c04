(* Functions that are rational on an open interval (u,v), together with their derivative (quotient rule).
   isd f f': on (u,v)  f = P/Q  and  f' = (P'Q - PQ')/Q^2  for polynomials P, Q, Q without a zero in (u,v).
   Any ordered field; only the last section (monotone if the derivative is >= 0) needs a real closed field. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
From mathcomp Require Import polyrcf.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Definition hE := (hornerD, hornerN, hornerM, hornerC, hornerX).

Section Isd.
Variable R : realFieldType.
Variables u v : R.
Notation inn := (fun x => u < x < v).

Definition isd_by (P Q : {poly R}) (f f' : R -> R) := forall x, u < x < v ->
  [/\ Q.[x] != 0, f x = P.[x] / Q.[x] & f' x = (P^`().[x] * Q.[x] - P.[x] * Q^`().[x]) / Q.[x] ^+ 2].
Definition isd (f f' : R -> R) := exists P Q : {poly R}, isd_by P Q f f'.

Lemma isd_ext f f' g g' : isd f f' -> (forall x, u < x < v -> g x = f x) ->
  (forall x, u < x < v -> g' x = f' x) -> isd g g'.
Proof. by case=> P [Q h] e e'; exists P, Q => x hx; have [h1 h2 h3] := h x hx; rewrite e // e'. Qed.

Lemma isd_const c : isd (fun _ => c) (fun _ => 0).
Proof.
exists c%:P, 1 => x _; rewrite derivC (_ : 1 = 1%:P) // derivC !hE; split; first exact: oner_neq0.
  by rewrite divr1.
by rewrite ?mulr0 ?mul0r ?subr0 ?oppr0 ?mul0r.
Qed.

Lemma isd_id : isd id (fun _ => 1).
Proof.
exists 'X, 1 => x _; rewrite derivX (_ : 1 = 1%:P) // derivC !hE; split; first exact: oner_neq0.
  by rewrite divr1.
by rewrite ?mulr0 ?mulr1 ?subr0 ?expr1n ?divr1.
Qed.

Lemma isd_add f f' g g' : isd f f' -> isd g g' -> isd (fun x => f x + g x) (fun x => f' x + g' x).
Proof.
case=> P [Q h] [P' [Q' h']]; exists (P * Q' + P' * Q), (Q * Q') => x hx.
have [n e1 e2] := h x hx; have [n' e1' e2'] := h' x hx.
split; [by rewrite !hE mulf_neq0 | rewrite !hE e1 e1' | rewrite derivD !derivM !hE ?e1 ?e1' e2 e2'];
move: n n'; move: P.[x] Q.[x] P'.[x] Q'.[x] P^`().[x] Q^`().[x] P'^`().[x] Q'^`().[x];
by move=> a1 a2 a3 a4 a5 a6 a7 a8 n n'; field; rewrite n n'.
Qed.

Lemma isd_mul f f' g g' : isd f f' -> isd g g' -> isd (fun x => f x * g x) (fun x => f' x * g x + f x * g' x).
Proof.
case=> P [Q h] [P' [Q' h']]; exists (P * P'), (Q * Q') => x hx.
have [n e1 e2] := h x hx; have [n' e1' e2'] := h' x hx.
split; [by rewrite !hE mulf_neq0 | rewrite !hE e1 e1' | rewrite !derivM !hE ?e1 ?e1' e2 e2'];
move: n n'; move: P.[x] Q.[x] P'.[x] Q'.[x] P^`().[x] Q^`().[x] P'^`().[x] Q'^`().[x];
by move=> a1 a2 a3 a4 a5 a6 a7 a8 n n'; field; rewrite n n'.
Qed.

Lemma isd_inv f f' : isd f f' -> (forall x, u < x < v -> f x != 0) ->
  isd (fun x => (f x)^-1) (fun x => - f' x / f x ^+ 2).
Proof.
case=> P [Q h] f0; exists Q, P => x hx.
have [n e1 e2] := h x hx; have := f0 x hx; rewrite e1 e2 => d.
have p : P.[x] != 0 by apply: contraNneq d => ->; rewrite mul0r.
split=> //; first by rewrite invf_div.
move: n p; move: P.[x] Q.[x] P^`().[x] Q^`().[x] => a1 a2 a3 a4 n p; by field; rewrite n p.
Qed.

Lemma isd_opp f f' : isd f f' -> isd (fun x => - f x) (fun x => - f' x).
Proof.
move=> h; apply: (isd_ext (isd_mul (isd_const (-1)) h)) => x _; first by rewrite mulN1r.
by rewrite mul0r add0r mulN1r.
Qed.
Lemma isd_sub f f' g g' : isd f f' -> isd g g' -> isd (fun x => f x - g x) (fun x => f' x - g' x).
Proof. by move=> h h'; apply: isd_add => //; apply: isd_opp. Qed.
Lemma isd_scale c f f' : isd f f' -> isd (fun x => c * f x) (fun x => c * f' x).
Proof. by move=> h; apply: (isd_ext (isd_mul (isd_const c) h)) => x _ //; rewrite mul0r add0r. Qed.
Lemma isd_div f f' g g' : isd f f' -> isd g g' -> (forall x, u < x < v -> g x != 0) ->
  isd (fun x => f x / g x) (fun x => (f' x * g x - f x * g' x) / g x ^+ 2).
Proof.
move=> h h' n; apply: (isd_ext (isd_mul h (isd_inv h' n))) => x hx //.
by have := n x hx => nx; field.
Qed.
Lemma isd_sum (I : Type) (s : seq I) (f f' : I -> R -> R) : (forall i, isd (f i) (f' i)) ->
  isd (fun x => \sum_(i <- s) f i x) (fun x => \sum_(i <- s) f' i x).
Proof.
move=> h; elim: s => [|i s IH].
  by apply: (isd_ext (isd_const 0)) => x _; rewrite big_nil.
by apply: (isd_ext (isd_add (h i) IH)) => x _; rewrite big_cons.
Qed.

(* The derivative is determined by the function. *)
Lemma poly0 (p : {poly R}) : u < v -> (forall x, u < x < v -> p.[x] = 0) -> p = 0.
Proof.
move=> uv h; pose pt i := u + (v - u) / i.+2%:R.
have d : 0 < v - u by rewrite subr_gt0.
have pin i : u < pt i < v.
  have i0 : 0 < i.+2%:R :> R by rewrite ltr0n.
  rewrite /pt ltr_addl divr_gt0 //= -ltr_subr_addl ltr_pdivr_mulr // ltr_pmulr //.
  by rewrite ltr1n.
have inj : injective pt.
  move=> i j /addrI /(mulfI (lt0r_neq0 d)) /invr_inj /eqP; rewrite eqr_nat => /eqP [] //.
apply: (@roots_geq_poly_eq0 _ p [seq pt i | i <- iota 0 (size p)]).
- by apply/allP => x /mapP[i _ ->]; rewrite rootE h.
- by rewrite map_inj_uniq ?iota_uniq.
- by rewrite size_map size_iota.
Qed.

(* a function has one derivative only *)
Theorem isd_uniq f f' g g' : isd f f' -> isd g g' -> (forall x, u < x < v -> f x = g x) ->
  forall x, u < x < v -> f' x = g' x.
Proof.
case=> P [Q h] [P' [Q' h']] e x hx.
have uv : u < v by case/andP: hx => h1 h2; apply: lt_trans h2.
have E : P * Q' - P' * Q = 0.
  apply: poly0 => // z hz; have [n e1 _] := h z hz; have [n' e1' _] := h' z hz.
  have := e z hz; rewrite e1 e1' => /eqP; rewrite eqr_div // => /eqP q.
  by rewrite !hE q mulrC subrr.
have [n e1 e2] := h x hx; have [n' e1' e2'] := h' x hx.
have E1 : (P * Q' - P' * Q)^`().[x] = 0 by rewrite E derivC hE.
have E0 : (P * Q' - P' * Q).[x] = 0 by rewrite E hE.
move: E1 E0; rewrite derivB !derivM !hE e2 e2' => E1 E0.
apply/eqP; rewrite -subr_eq0; apply/eqP.
move: n n' E1 E0; move: P.[x] Q.[x] P'.[x] Q'.[x] P^`().[x] Q^`().[x] P'^`().[x] Q'^`().[x].
move=> p q p' q' dp dq dp' dq' n n' E1 E0.
have -> : (dp * q - p * dq) / q ^+ 2 - (dp' * q' - p' * dq') / q' ^+ 2 =
  ((dp * q' + p * dq' - (dp' * q + p' * dq)) * q * q' - (p * q' - p' * q) * (dq * q' + q * dq')) / (q ^+ 2 * q' ^+ 2).
  by field; rewrite n n'.
by rewrite E1 E0 !mul0r subrr mul0r.
Qed.

(* f' is the derivative in the usual sense: f(z) = f(x) + (z - x) f'(x) + (z - x)^2 S(z)/(Q(z) Q(x)^2), S a polynomial. *)
Theorem isd_taylor f f' : isd f f' -> exists Q : {poly R}, (forall z, u < z < v -> Q.[z] != 0) /\
  forall x, u < x < v -> exists S : {poly R}, forall z, u < z < v ->
    f z = f x + (z - x) * f' x + (z - x) ^+ 2 * (S.[z] / Q.[z]).
Proof.
case=> P [Q h]; exists Q; split=> [z /h[] //|x hx].
have [n e1 e2] := h x hx.
pose F := P - (f x)%:P * Q - (f' x)%:P * ('X - x%:P) * Q.
have F0 : root F x by rewrite rootE /F !hE e1 subrr mulr0 mul0r subr0 divfK // subrr.
have [F1 EF] := factor_theorem F x F0.
have d : F^`().[x] = 0.
  rewrite /F !derivB !derivM !derivC derivB derivX derivC !hE subrr !mul0r !mulr0 !add0r ?addr0 ?mulr1 e1 e2.
  move: n; move: P.[x] Q.[x] P^`().[x] Q^`().[x] => p q dp dq n.
  by rewrite ?subr0 ?mul0r ?addr0; field.
have r1 : root F1 x.
  by move: d; rewrite EF derivM derivXsubC !hE subrr mulr0 add0r mulr1 rootE => ->.
have [S ES] := factor_theorem F1 x r1.
exists S => z hz; have [nz ez _] := h z hz.
have : F.[z] = S.[z] * (z - x) ^+ 2 by rewrite EF ES !hE expr2 mulrA.
rewrite /F !hE => E.
move: E nz; rewrite ez; move: P.[z] Q.[z] S.[z] (f x) (f' x) => p q s0 a b E nz.
have -> : p = a * q + b * (z - x) * q + s0 * (z - x) ^+ 2 by rewrite -E; ring.
by field.
Qed.
(* a rational function without poles in (u,v) has derivatives of every order there, and they are such functions *)
Definition rational (f : R -> R) := exists P Q : {poly R}, forall x, u < x < v -> Q.[x] != 0 /\ f x = P.[x] / Q.[x].
Definition smooth (f : R -> R) := exists F : nat -> R -> R, (forall x, u < x < v -> F 0%N x = f x) /\ forall q, isd (F q) (F q.+1).
Fixpoint quotients (P Q : {poly R}) (q : nat) : {poly R} * {poly R} :=
  if q is q'.+1 then let PQ := quotients P Q q' in (PQ.1^`() * PQ.2 - PQ.1 * PQ.2^`(), PQ.2 ^+ 2) else (P, Q).
(* a rational function without poles has derivatives of every order *)
Theorem rational_smooth f : rational f -> smooth f.
Proof.
case=> P [Q h]; exists (fun q x => (quotients P Q q).1.[x] / (quotients P Q q).2.[x]); split.
  by move=> x hx; have [_ ->] := h x hx.
have n q x : u < x < v -> (quotients P Q q).2.[x] != 0.
  by elim: q => [|q IH] hx /=; [have [] := h x hx|rewrite horner_exp expf_neq0 ?IH].
move=> q; exists (quotients P Q q).1, (quotients P Q q).2 => x hx; split => //; first exact: n.
by rewrite /= horner_exp !hE.
Qed.
Lemma isd_rational f f' : isd f f' -> rational f.
Proof. by case=> P [Q h]; exists P, Q => x hx; have [] := h x hx. Qed.
End Isd.

(* Real closed field: derivative >= 0 on (u,v) makes f non-decreasing there. *)
Section Mono.
Variable R : rcfType.

Lemma no_rising_roots (F : {poly R}) (x y : R) : x < y ->
  (forall z, x <= z <= y -> F.[z] = 0 -> 0 < F^`().[z]) -> F.[x] = 0 -> F.[y] = 0 -> False.
Proof.
move=> xy hF Fx Fy.
have F0 : F != 0.
  by apply: contraTneq (hF x _ Fx) => [->|]; rewrite ?derivC ?hE ?ltxx // lexx ltW.
have step z : x < z <= y -> F.[z] = 0 -> exists2 w, x < w < z & F.[w] = 0.
  case/andP=> xz zy Fz.
  have [F1 E1] := factor_theorem F x (introT eqP Fx).
  have : root F1 z.
    by move: Fz; rewrite E1 !hE => /eqP; rewrite mulf_eq0 subr_eq0 (gt_eqF xz) orbF.
  case/factor_theorem=> F2 E2.
  have E : F = F2 * ('X - z%:P) * ('X - x%:P) by rewrite E1 E2.
  have dx : F^`().[x] = F2.[x] * (x - z).
    by rewrite E !derivM !derivXsubC !hE subrr !mulr0 ?add0r ?mulr1.
  have dz : F^`().[z] = F2.[z] * (z - x).
    by rewrite E !derivM !derivXsubC !hE subrr !mulr0 ?add0r ?mulr1 ?addr0 ?mul0r ?addr0.
  have hx : 0 < F^`().[x] by apply: hF; rewrite ?lexx ?ltW.
  have hz : 0 < F^`().[z] by apply: hF; rewrite ?(ltW xz).
  have f2z : 0 < F2.[z] by move: hz; rewrite dz pmulr_lgt0 // subr_gt0.
  have f2x : F2.[x] < 0 by move: hx; rewrite dx nmulr_lgt0 // subr_lt0.
  have [|w] := @ivt_sign R F2 x z (ltW xz); first by rewrite (gtr0_sg f2z) (ltr0_sg f2x) mulr1.
  rewrite inE /= => hw rw; exists w => //.
  by rewrite E !hE; move: rw; rewrite rootE => /eqP ->; rewrite !mul0r.
have all_roots z : x < z <= y -> F.[z] = 0 -> forall n, exists s : seq R,
    [/\ size s = n, path (fun a b => b < a) z s & all (fun w => (x < w <= y) && root F w) s].
  move=> hz Fz n; elim: n z hz Fz => [|n IH] z hz Fz; first by exists [::].
  have [w /andP[xw wz] Fw] := step z hz Fz.
  have hw : x < w <= y by rewrite xw (le_trans (ltW wz)) //; case/andP: hz.
  have [s [zs ps as_]] := IH w hw Fw.
  by exists (w :: s); rewrite /= zs wz ps hw rootE Fw eqxx.
have [|s [zs ps as_]] := all_roots y _ Fy (size F); first by rewrite xy lexx.
have un : uniq s.
  have tr : transitive (fun a b : R => b < a) by move=> a b d h1 h2; apply: lt_trans h1.
  have irr : irreflexive (fun a b : R => b < a) by move=> a; rewrite ltxx.
  exact: (sorted_uniq tr irr (path_sorted ps)).
have ar : all (root F) s by apply/allP => w /(allP as_) /andP[].
by have := max_poly_roots F0 ar un; rewrite zs ltnn.
Qed.


(* a rational function that does not rise from x to y has f' <= its slope somewhere in [x,y] *)
Lemma isd_slope (u v : R) (f f' : R -> R) x y : isd u v f f' -> u < x -> x < y -> y < v ->
  (forall z, x <= z <= y -> (f y - f x) / (y - x) < f' z) -> False.
Proof.
case=> P [Q h] ux xy yv; set m := (f y - f x) / (y - x) => f0.
have d : 0 < y - x by rewrite subr_gt0.
have inn z : x <= z <= y -> u < z < v.
  by case/andP=> h1 h2; rewrite (lt_le_trans ux h1) (le_lt_trans h2 yv).
have [L [Lx Ly dL]] : exists L : {poly R}, [/\ L.[x] = f x, L.[y] = f y & forall z, L^`().[z] = m].
  exists ((f x)%:P + m%:P * ('X - x%:P)); split.
  - by rewrite !hE subrr mulr0 addr0.
  - by rewrite !hE /m divfK ?gt_eqF // addrC subrK.
  - by move=> z; rewrite derivD derivM !derivC derivXsubC (_ : 1 = 1%:P) // !hE mul0r !add0r mulr1.
pose F := (P - L * Q) * Q.
have Fz z : u < z < v -> F.[z] = (f z - L.[z]) * Q.[z] ^+ 2.
  by move=> hz; have [n e _] := h z hz; rewrite /F !hE e; move: n; move: P.[z] Q.[z] L.[z] => p q l n; field.
apply: (@no_rising_roots F x y xy); last first.
- by rewrite Fz ?inn ?lexx ?ltW // Ly subrr mul0r.
- by rewrite Fz ?inn ?lexx ?ltW // Lx subrr mul0r.
move=> z hz; have hz' := inn z hz; have [n e1 e2] := h z hz'.
rewrite Fz // => /eqP; rewrite mulf_eq0 sqrf_eq0 (negbTE n) orbF subr_eq0 => /eqP fL.
have q0 : 0 < Q.[z] ^+ 2 by rewrite exprn_even_gt0.
have PE : P.[z] = L.[z] * Q.[z] by rewrite -fL e1 divfK.
have -> : F^`().[z] = Q.[z] ^+ 2 * (f' z - m).
  rewrite /F derivM derivB derivM !hE dL e2 PE.
  by move: n; move: Q.[z] Q^`().[z] P^`().[z] L.[z] => q dq dp l n; field.
by rewrite mulr_gt0 // subr_gt0 f0.
Qed.

(* a derivative that is not negative on [x,y] makes f(x) <= f(y) *)
Theorem isd_mono_seg (u v : R) (f f' : R -> R) x y : isd u v f f' -> u < x -> x <= y -> y < v ->
  (forall z, x <= z <= y -> 0 <= f' z) -> f x <= f y.
Proof.
move=> h ux; rewrite le_eqVlt => /orP[/eqP ->|xy yv f0]; first by rewrite lexx.
rewrite leNgt; apply/negP => fyx; apply: (isd_slope h ux xy yv) => z hz.
by apply: lt_le_trans (f0 z hz); rewrite pmulr_llt0 ?invr_gt0 ?subr_gt0 // subr_lt0.
Qed.
(* a positive one makes f(x) < f(y) *)
Theorem isd_mono_strict (u v : R) (f f' : R -> R) x y : isd u v f f' -> u < x -> x < y -> y < v ->
  (forall z, x <= z <= y -> 0 < f' z) -> f x < f y.
Proof.
move=> h ux xy yv f0.
rewrite ltNge; apply/negP => fyx; apply: (isd_slope h ux xy yv) => z hz.
by apply: le_lt_trans (f0 z hz); rewrite pmulr_lle0 ?invr_gt0 ?subr_gt0 // subr_le0.
Qed.
(* the same on the whole interval *)
Corollary isd_mono (u v : R) (f f' : R -> R) : isd u v f f' -> (forall x, u < x < v -> 0 <= f' x) ->
  forall x y, u < x -> x <= y -> y < v -> f x <= f y.
Proof.
move=> h f0 x y ux xy yv; apply: (isd_mono_seg h) => // z /andP[h1 h2]; apply: f0.
by rewrite (lt_le_trans ux) // (le_lt_trans h2).
Qed.
End Mono.
