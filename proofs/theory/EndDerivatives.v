(* Derivatives of every order at the first knot of a span, from the right, and at t_m, from the left: of which order a function vanishes
   there, and the sign of the first derivative that is not 0. proof.P3.2.induction and P4.2.tangent as amended. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values RationalDerivative HigherDerivatives.
From Bsplines Require Import StatementsBasis StatementsDerivatives StatementsCurves.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Lead.
Variable R : realFieldType.
Implicit Types (P Q : {poly R}) (y a : R) (f g : R -> R).
(* ---- orders along the recursion, for any weights ---- *)
Section Recursion.
Variables (v : nat -> nat -> R -> R) (s : nat) (y : R).
Local Notation Nv := (fun d i x => N (fun e j => v e j x) s d i).
(* at the left end of the span: the knots i0, .., s are there *)
Theorem N_lead_start i0 : (forall e l, (i0 <= l <= s)%N -> (s < l + e)%N -> exists2 a, leading y 1 (v e l) a & 0 < a) ->
  forall d i, (i0 <= i <= s)%N -> (s <= i + d)%N -> exists2 a, leading y (d - (s - i)) (Nv d i) a & 0 < a.
Proof.
move=> h; have h1 e l : (i0 <= l <= s)%N -> (s < l + e)%N -> leading y 0 (fun x => 1 - v e l x) 1.
  move=> hl he; have [a a1 a2] := h e l hl he; rewrite -[X in leading _ _ _ X]subr0.
  by apply: leading_sub; [exact: leading_const|exact: leading_lt a1].
elim=> [|d IH] i hi hd.
  have -> : i = s by move: hi hd; clear; lia.
  by exists 1; rewrite ?ltr01 //; apply: (leading_ext _ (leading_const y 1)) => x /=; rewrite eqxx.
have A : (s <= i + d)%N -> exists2 a, leading y (d.+1 - (s - i)) (fun x => v d.+1 i x * Nv d i x) a & 0 < a.
  move=> e; have [a a1 a2] := h d.+1 i hi ltac:(by rewrite addnS ltnS); have [b b1 b2] := IH i hi e.
  exists (a * b); last exact: mulr_gt0.
  have -> : (d.+1 - (s - i) = 1 + (d - (s - i)))%N by move: hi e; clear; lia.
  exact: leading_mul a1 b1.
have B : (i < s)%N -> exists2 a, leading y (d.+1 - (s - i)) (fun x => (1 - v d.+1 i.+1 x) * Nv d i.+1 x) a & 0 < a.
  move=> e; have [|b b1 b2] := IH i.+1 _ ltac:(by rewrite addSnnS); first by move: hi e; clear; lia.
  exists b => //; rewrite -[b]mul1r; have -> : (d.+1 - (s - i) = 0 + (d - (s - i.+1)))%N by move: e; clear; lia.
  by apply: leading_mul b1; apply: h1; move: hi e hd; clear; lia.
case: (leqP s (i + d)) => e; last first.
  have [|b b1 b2] := B; first by move: e; clear; lia.
  exists b => //; apply: (leading_ext _ b1) => x; rewrite NS [N _ s d i]N_supp ?mulr0 ?add0r //; move: e; clear; lia.
have [a a1 a2] := A e; case: (ltnP i s) => e'; last first.
  exists a => //; apply: (leading_ext _ a1) => x; rewrite NS [N _ s d i.+1]N_supp ?mulr0 ?addr0 //; move: e'; clear; lia.
have [b b1 b2] := B e'; exists (a + b); last exact: addr_gt0.
exact: leading_add a1 b1.
Qed.
(* at the right end of the span: the knots s+1, .., b are there *)
Theorem N_lead_stop b : (forall e l, (l <= s)%N -> (s < l + e <= b)%N -> exists2 a, leading y 1 (fun x => 1 - v e l x) (- a) & 0 < a) ->
  forall d i, (i <= s)%N -> (s <= i + d)%N -> (i + d < b)%N -> exists2 a, leading y (s - i) (Nv d i) ((-1) ^+ (s - i) * a) & 0 < a.
Proof.
move=> h; have h1 e l : (l <= s)%N -> (s < l + e <= b)%N -> leading y 0 (v e l) 1.
  move=> hl he; have [a a1 a2] := h e l hl he; have := leading_sub (leading_const y 1) (leading_lt (ltnSn 0) a1).
  by rewrite subr0; apply: leading_ext => x; rewrite opprB addrC subrK.
elim=> [|d IH] i hi hd hb.
  have -> : i = s by move: hi hd; clear; lia.
  exists 1; rewrite ?ltr01 // subnn expr0 mulr1; apply: (leading_ext _ (leading_const y 1)) => x /=; by rewrite eqxx.
have A : (s <= i + d)%N -> exists2 a, leading y (s - i) (fun x => v d.+1 i x * Nv d i x) ((-1) ^+ (s - i) * a) & 0 < a.
  move=> e; have [|a a1 a2] := IH i hi e; first by move: hb; clear; lia.
  exists a => //; rewrite -[_ * a]mul1r -[(s - i)%N]add0n; apply: leading_mul a1; apply: h1 => //.
  by move: e hb; clear; lia.
have B : (i < s)%N -> exists2 a, leading y (s - i) (fun x => (1 - v d.+1 i.+1 x) * Nv d i.+1 x) ((-1) ^+ (s - i) * a) & 0 < a.
  move=> e; have [|a a1 a2] := h d.+1 i.+1 e; first by move: hd hb; clear; lia.
  have [||c c1 c2] := IH i.+1 e; [by move: hd; clear; lia|by move: hb; clear; lia|].
  exists (a * c); last exact: mulr_gt0.
  have -> : (s - i = (s - i.+1).+1)%N by rewrite subnSK.
  have -> : (-1) ^+ (s - i.+1).+1 * (a * c) = - a * ((-1) ^+ (s - i.+1) * c) by rewrite exprS; ring.
  by rewrite -add1n; exact: leading_mul a1 c1.
case: (leqP s (i + d)) => e; last first.
  have [|c c1 c2] := B; first by move: e; clear; lia.
  exists c => //; apply: (leading_ext _ c1) => x; rewrite NS [N _ s d i]N_supp ?mulr0 ?add0r //; move: e; clear; lia.
have [a a1 a2] := A e; case: (ltnP i s) => e'; last first.
  exists a => //; apply: (leading_ext _ a1) => x; rewrite NS [N _ s d i.+1]N_supp ?mulr0 ?addr0 //; move: e'; clear; lia.
have [c c1 c2] := B e'; exists (a + c); last exact: addr_gt0.
rewrite mulrDr; exact: leading_add a1 c1.
Qed.
End Recursion.

(* ---- the derivatives at y of a function of order M there ---- *)
Lemma quotients_0 Q q : (quotients 0 Q q).1 = 0.
Proof. by elim: q => //= q ->; rewrite derivC !mul0r subrr. Qed.
Lemma Dq_const (c y : R) q : Dq c%:P 1 q.+1 y = 0.
Proof.
rewrite /Dq; suff -> : (quotients c%:P 1 q.+1).1 = 0 by rewrite horner0 mul0r.
by elim: q => [|q IH]; rewrite [quotients _ _ _]/= /= ?derivC ?mul0r ?mulr0 ?subrr //; move: IH => /= ->; rewrite derivC !mul0r subrr.
Qed.
Lemma leading_D y M f a P Q : Q.[y] != 0 -> (forall x, Q.[x] != 0 -> f x = P.[x] / Q.[x]) -> leading y M f a ->
  (forall q, (q < M)%N -> Dq P Q q y = 0) /\ Dq P Q M y = M`!%:R * a.
Proof.
move=> nQ e h; have n1 : (1 : {poly R}).[y] != 0 by rewrite hornerC oner_neq0.
have z q : Dq 0 1 q y = 0 by rewrite /Dq quotients_0 horner0 mul0r.
have [|j1 j2] := @leading_jump R y M 0 1 P Q a n1 nQ.
  by apply: (leading_near nQ _ h) => x hx; rewrite e // horner0 mul0r subr0.
by split=> [q qM|]; [rewrite -j1 ?z|rewrite -j2 z subr0].
Qed.
Theorem leading_right y M f a c : y < c -> leading y M f a ->
  forall g, (forall x, y < x < c -> g x = f x) -> exists F, [/\ forall q, derivative_right q g y (F q), forall q, (q < M)%N -> F q = 0 & F M = M`!%:R * a].
Proof.
move=> yc h g e; have [S [Q [nQ _ hS]]] := h; pose P := ('X - y%:P) ^+ M * S.
have eP x : Q.[x] != 0 -> f x = P.[x] / Q.[x] by move=> hx; rewrite hS // /P hornerM horner_exp hornerXsubC mulrA.
have [D1 D2] := leading_D nQ eP h; exists (fun q => Dq P Q q y); split => // q.
have [d d0 hd] := poly_near0 nQ; have d1 : 0 < Num.min d (c - y) by rewrite lt_minr d0 subr_gt0.
apply: (quotient_right d1 nQ) => x /andP[x1 x2]; move: x2; rewrite -ltr_subl_addl lt_minr => /andP[a1 a2].
rewrite e; last by rewrite x1; move: a2; rewrite ltr_add2r.
by apply: eP; apply: hd; rewrite -ltr_subl_addl a1 andbT (lt_trans _ x1) // ltr_subl_addr ltr_addl.
Qed.
Theorem leading_left y M f a c : c < y -> leading y M f a ->
  forall g, (forall x, c < x < y -> g x = f x) -> exists F, [/\ forall q, derivative_left q g y (F q), forall q, (q < M)%N -> F q = 0 & F M = M`!%:R * a].
Proof.
move=> yc h g e; have [S [Q [nQ _ hS]]] := h; pose P := ('X - y%:P) ^+ M * S.
have eP x : Q.[x] != 0 -> f x = P.[x] / Q.[x] by move=> hx; rewrite hS // /P hornerM horner_exp hornerXsubC mulrA.
have [D1 D2] := leading_D nQ eP h; exists (fun q => Dq P Q q y); split => // q.
have [d d0 hd] := poly_near0 nQ; have d1 : 0 < Num.min d (y - c) by rewrite lt_minr d0 subr_gt0.
apply: (quotient_left d1 nQ) => x /andP[x1 x2]; move: x1; rewrite ltr_subl_addr -ltr_subl_addl lt_minr => /andP[a1 a2].
rewrite e; last by rewrite x2 andbT; move: a2; rewrite ltr_add2l ltr_opp2.
by apply: eP; apply: hd; rewrite (lt_trans x2) ?ltr_addl // andbT ltr_subl_addr -ltr_subl_addl.
Qed.

(* ---- derivatives of sums ---- *)
Lemma small_sum (c u w eps : R) : 0 < eps -> `|u| < eps / 2%:R -> `|w| < eps / 2%:R / (`|c| + 1) -> `|u + c * w| < eps.
Proof.
move=> e0 h1 h2; have c1 : 0 < `|c| + 1 by rewrite ltr_paddl ?ltr01.
apply: le_lt_trans (ler_norm_add _ _) _; rewrite [X in _ < X](_ : eps = eps / 2%:R + eps / 2%:R); last by field.
apply: ltr_le_add => //; rewrite normrM; apply: (@le_trans _ _ ((`|c| + 1) * `|w|)).
  by rewrite ler_wpmul2r // ler_addl ler01.
by rewrite mulrC -ler_pdivl_mulr // ltW.
Qed.
Lemma derivative_right_lin q f g y v w c : derivative_right q f y v -> derivative_right q g y w ->
  derivative_right q (fun x => f x + c * g x) y (v + c * w).
Proof.
move=> [d [F [d0 F0 cF lF]]] [d' [H [d0' H0 cH lH]]].
exists (Num.min d d'), (fun j x => F j x + c * H j x); split; first by rewrite lt_minr d0.
- move=> x /andP[x1]; rewrite -ltr_subl_addl lt_minr !ltr_subl_addl => /andP[a1 a2]; by rewrite F0 ?H0 ?x1.
- move=> j jq; apply: isd_add; first by apply: isd_sub_itv (cF j jq) => //; rewrite ler_add2l le_minl lexx.
  by apply: isd_scale; apply: isd_sub_itv (cH j jq) => //; rewrite ler_add2l le_minl lexx orbT.
have c1 : 0 < `|c| + 1 by rewrite ltr_paddl ?ltr01.
move=> eps e0; have [e1 e10 h1] := lF (eps / 2%:R) ltac:(by rewrite divr_gt0 ?ltr0n).
have [e2 e20 h2] := lH (eps / 2%:R / (`|c| + 1)) ltac:(by rewrite !divr_gt0 ?ltr0n).
exists (Num.min e1 e2); first by rewrite lt_minr e10.
move=> x /andP[x1]; rewrite -ltr_subl_addl lt_minr !ltr_subl_addl => /andP[a1 a2].
have -> : F q x + c * H q x - (v + c * w) = (F q x - v) + c * (H q x - w) by ring.
by apply: small_sum => //; [apply: h1|apply: h2]; rewrite x1.
Qed.
Lemma derivative_left_lin q f g y v w c : derivative_left q f y v -> derivative_left q g y w ->
  derivative_left q (fun x => f x + c * g x) y (v + c * w).
Proof.
move=> [d [F [d0 F0 cF lF]]] [d' [H [d0' H0 cH lH]]].
have sub x e : (y - e < x) = (y - x < e) by rewrite ltr_subl_addr -ltr_subl_addl.
exists (Num.min d d'), (fun j x => F j x + c * H j x); split; first by rewrite lt_minr d0.
- move=> x /andP[]; rewrite sub lt_minr => /andP[a1 a2] x1; rewrite F0; last by rewrite x1 sub a1.
  by rewrite H0 // x1 sub a2.
- move=> j jq; apply: isd_add; first by apply: isd_sub_itv (cF j jq) => //; rewrite ler_add2l ler_opp2 le_minl lexx.
  by apply: isd_scale; apply: isd_sub_itv (cH j jq) => //; rewrite ler_add2l ler_opp2 le_minl lexx orbT.
have c1 : 0 < `|c| + 1 by rewrite ltr_paddl ?ltr01.
move=> eps e0; have [e1 e10 h1] := lF (eps / 2%:R) ltac:(by rewrite divr_gt0 ?ltr0n).
have [e2 e20 h2] := lH (eps / 2%:R / (`|c| + 1)) ltac:(by rewrite !divr_gt0 ?ltr0n).
exists (Num.min e1 e2); first by rewrite lt_minr e10.
move=> x /andP[]; rewrite sub lt_minr => /andP[a1 a2] x1.
have -> : F q x + c * H q x - (v + c * w) = (F q x - v) + c * (H q x - w) by ring.
by apply: small_sum => //; [apply: h1|apply: h2]; rewrite x1 sub ?a1 ?a2.
Qed.
Lemma derivative_right_const q y (c : R) : derivative_right q.+1 (fun _ => c) y 0.
Proof.
have n1 : (1 : {poly R}).[y] != 0 by rewrite hornerC oner_neq0.
rewrite -(Dq_const c y q); apply: (quotient_right ltr01 n1) => x _; by rewrite !hornerC divr1.
Qed.
Lemma derivative_left_const q y (c : R) : derivative_left q.+1 (fun _ => c) y 0.
Proof.
have n1 : (1 : {poly R}).[y] != 0 by rewrite hornerC oner_neq0.
rewrite -(Dq_const c y q); apply: (quotient_left ltr01 n1) => x _; by rewrite !hornerC divr1.
Qed.
Lemma derivative_right_sum q (f : nat -> R -> R) y (v d : nat -> R) b : (forall i, (i < b)%N -> derivative_right q.+1 (f i) y (v i)) ->
  derivative_right q.+1 (fun x => \sum_(0 <= i < b) d i * f i x) y (\sum_(0 <= i < b) d i * v i).
Proof.
elim: b => [|b IH] h.
  rewrite big_geq //; apply: (derivative_right_ext (c := y + 1)) (derivative_right_const q y 0); first by rewrite ltr_addl ltr01.
  by move=> x _; rewrite big_geq.
rewrite big_nat_recr //=; have := derivative_right_lin (d b) (IH (fun i hi => h i (leqW hi))) (h b (ltnSn b)).
apply: (derivative_right_ext (c := y + 1)); first by rewrite ltr_addl ltr01.
by move=> x _; rewrite big_nat_recr.
Qed.
Lemma derivative_left_sum q (f : nat -> R -> R) y (v d : nat -> R) b : (forall i, (i < b)%N -> derivative_left q.+1 (f i) y (v i)) ->
  derivative_left q.+1 (fun x => \sum_(0 <= i < b) d i * f i x) y (\sum_(0 <= i < b) d i * v i).
Proof.
have y1 : y - 1 < y by rewrite ltr_subl_addr ltr_addl ltr01.
elim: b => [|b IH] h.
  rewrite big_geq //; apply: (derivative_left_ext y1) (derivative_left_const q y 0).
  by move=> x _; rewrite big_geq.
rewrite big_nat_recr //=; have := derivative_left_lin (d b) (IH (fun i hi => h i (leqW hi))) (h b (ltnSn b)).
by apply: (derivative_left_ext y1) => x _; rewrite big_nat_recr.
Qed.

(* finitely many choices *)
Lemma fin_choice (T : Type) (x0 : T) (P : nat -> T -> Prop) b : (forall l, (l < b)%N -> exists F, P l F) -> exists G, forall l, (l < b)%N -> P l (G l).
Proof.
elim: b => [|b IH] h; first by exists (fun _ => x0).
have [G hG] := IH (fun l hl => h l (leqW hl)); have [F hF] := h b (ltnSn b).
exists (fun l => if l == b then F else G l) => l; rewrite ltnS leq_eqVlt => /orP[/eqP ->|lt]; first by rewrite eqxx.
by rewrite (ltn_eqF lt); exact: hG.
Qed.
(* only the first i+1 functions act on a derivative of order i, and the first of them by what the others do *)
Lemma end_sum (F d : nat -> R) n i : (i < n)%N -> \sum_(0 <= l < n.+1) 1 * F l = 0 -> (forall l, (i.+1 < l <= n)%N -> F l = 0) ->
  \sum_(0 <= l < n.+1) d l * F l = \sum_(1 <= l < i.+2) F l * (d l - d 0%N).
Proof.
move=> im s0 z; have -> : \sum_(0 <= l < n.+1) d l * F l = \sum_(0 <= l < n.+1) (d l * F l - d 0%N * (1 * F l)).
  by rewrite sumrB -mulr_sumr s0 mulr0 subr0.
rewrite big_ltn //.
rewrite mul1r subrr add0r (big_cat_nat _ (n := i.+2)) //=.
rewrite [X in _ + X]big_nat_cond [X in _ + X]big1 ?addr0; last by move=> l /andP[/andP[l1 l2] _]; rewrite z ?mulr0 ?subr0 // l1 -ltnS.
by apply: eq_bigr => l _; rewrite mul1r -mulrBl mulrC.
Qed.
End Lead.

Section Statements.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Let tle := t_le t_mono.
Local Notation value := (value r t m).
Local Notation C := (coordinate r t n k).

Lemma mw_lead_start e l y : t l = y -> y < t (l + e)%N -> exists2 a, leading y 1 (mw r t e l) a & 0 < a.
Proof.
move=> hl h; have b0 : 0 < t (l + e)%N - y by rewrite subr_gt0.
pose Q : {poly R} := r%:P * ('X - y%:P) + ((t (l + e)%N)%:P - 'X).
have EQ x : Q.[x] = r * (x - y) + (t (l + e)%N - x) by rewrite /Q !hE.
exists (r / (t (l + e)%N - y)); last exact: divr_gt0.
exists r%:P, Q; rewrite EQ subrr mulr0 add0r hornerC; split => // [|x _]; first by rewrite gt_eqF.
by rewrite EQ hornerC expr1 /mw hl /mob [RHS]mulrCA mulrA.
Qed.
Lemma mw_lead_stop e l y : t (l + e)%N = y -> t l < y -> exists2 a, leading y 1 (fun x => 1 - mw r t e l x) (- a) & 0 < a.
Proof.
move=> hl h; have b0 : 0 < r * (y - t l) by rewrite mulr_gt0 // subr_gt0.
pose Q : {poly R} := r%:P * ('X - (t l)%:P) + (y%:P - 'X).
have EQ x : Q.[x] = r * (x - t l) + (y - x) by rewrite /Q !hE.
exists (r * (y - t l))^-1; last by rewrite invr_gt0.
exists (-1)%:P, Q; rewrite EQ subrr addr0 !hornerC mulN1r; split => // [|x nx]; first by rewrite gt_eqF.
rewrite EQ in nx *; rewrite hornerC expr1 /mw /mob hl.
by move: nx; move: (t l) => b nx; field.
Qed.

(* proof.P3.2.induction as amended: the functions that begin at the first knot t_j of a span have different orders there *)
Theorem proof_P3_2_induction_amended i j : (i <= n)%N -> (j < m)%N -> t i = t j -> t j < t j.+1 -> (i <= j <= i + k)%N ->
  exists F, [/\ forall q, derivative_right q (value k i) (t j) (F q), forall q, (q < k - (j - i))%N -> F q = 0 & 0 < F (k - (j - i))%N].
Proof.
move=> im jm e h /andP[ij jk].
have [|||a a1 a2] := @N_lead_start R (mw r t) j (t j) i _ k i; rewrite ?leqnn ?ij //.
  move=> d l /andP[l1 l2] l3; apply: mw_lead_start; last by apply: (lt_le_trans h); apply: tle.
  by apply/eqP; rewrite eq_le tle // -e tle.
have [F [F1 F2 F3]] := leading_right h a1 (g := value k i) ltac:(move=> x /andP[x1 x2];
  rewrite value_in ?(lt_le_trans x2 (tle jm)) // (G_P r t_mono _ _ (s := j)) // (ltW x1) //).
by exists F; split => //; rewrite F3 mulr_gt0 // ltr0n fact_gt0.
Qed.

(* P4.2.tangent as amended: the derivatives of order i of a curve at its ends, i = 1, .., k *)
Theorem P4_2_tangent_amended d i : (1 <= k)%N -> Uclamped t n k -> (1 <= i <= k)%N -> exists F F',
  [/\ forall l, (l <= n)%N -> derivative_right i (value k l) (t 0%N) (F l),
      derivative_right i (C d) (t 0%N) (\sum_(1 <= l < i.+1) F l * (d l - d 0%N)) & 0 < F i] /\
  [/\ forall l, (l <= n)%N -> derivative_left i (value k l) (t m) (F' l),
      derivative_left i (C d) (t m) (\sum_(1 <= l < i.+1) F' (n - l)%N * (d (n - l)%N - d n)) & 0 < (-1) ^+ i * F' (n - i)%N].
Proof.
move=> k1 hc /andP[i1 ik]; have [ho h1 h2] := hc; have [e0 e1 e2] := ho; have kn := Uopen_kn t_mono e2.
have U := Uopen_t0 ho; case: i i1 ik => // i _ ik.
have tk l : (l <= k)%N -> t l = t 0%N by move=> hl; apply/eqP; rewrite eq_le {1}e0 !tle.
have tm l : (n < l <= m)%N -> t l = t m by move=> /andP[l1 l2]; apply/eqP; rewrite eq_le tle // -e1 tle.
have s0 : t 0%N < t k.+1 by rewrite e0.
have sm : t n < t m by rewrite -e1.
have km : (k.+1 <= m)%N by exact: leq_addl.
have S1 x : t 0%N <= x <= t m -> \sum_(0 <= l < n.+1) value k l x = 1 by move=> hx; have [] := P4_1_3_printed r_gt0 t_mono U ho hx.
(* orders at t_0 *)
have A l : (l <= n)%N -> exists F, [/\ forall q, derivative_right q (value k l) (t 0%N) (F q), forall q, (q < l)%N -> F q = 0 & (l <= k)%N -> 0 < F l].
  move=> ln; case: (leqP l k) => lk.
    have [|||F [F1 F2 F3]] := @proof_P3_2_induction_amended l k ln _ _ h1; rewrite ?lk ?leq_addl ?tk //.
    by exists F; rewrite subKn // in F2 F3; rewrite tk // in F1.
  have [F [F1 F2 _]] := leading_right s0 (leading0 (t 0%N) l) (g := value k l) ltac:(move=> x /andP[x1 x2];
    rewrite value_in ?(lt_le_trans x2 (tle km)) // (G_N t_mono _ _ _ (s := k)) ?N_supp // -?e0 ?(ltW x1) // negb_and -ltnNge lk //).
  by exists F; split => // lk'; move: lk; rewrite ltnNge lk'.
(* and at t_m *)
have B l : (l <= n)%N -> exists F, [/\ forall q, derivative_left q (value k (n - l)) (t m) (F q), forall q, (q < l)%N -> F q = 0 & (l <= k)%N -> 0 < (-1) ^+ l * F l].
  move=> ln; have near x : t n < x -> x < t m -> value k (n - l) x = N (fun e j => mw r t e j x) n k (n - l).
    by move=> x1 x2; rewrite value_in // (G_P r t_mono _ _ (s := n)) ?(ltW x1) ?e1.
  case: (leqP l k) => lk; last first.
    have [F [F1 F2 _]] := leading_left sm (leading0 (t m) l) (g := value k (n - l)) ltac:(move=> x /andP[x1 x2]; rewrite near // N_supp //;
      move: lk ln; clear; lia).
    by exists F; split => // lk'; move: lk; rewrite ltnNge lk'.
  have [||||a a1 a2] := @N_lead_stop R (mw r t) n (t m) m _ k (n - l); try (move: lk ln; clear; lia).
    move=> e j hj he; apply: mw_lead_stop; first exact: tm.
    exact: le_lt_trans (tle hj) sm.
  have [F [F1 F2 F3]] := leading_left sm a1 (g := value k (n - l)) ltac:(move=> x /andP[x1 x2]; exact: near).
  rewrite subKn // in F2 F3; exists F; split => // _; by rewrite F3 mulrCA mulrA -mulrA [(-1) ^+ l * (_ * a)]mulrA -expr2 sqrr_sign mul1r mulr_gt0 // ltr0n fact_gt0.
have [G hG] := @fin_choice _ (fun _ => 0) _ n.+1 A; have [H hH] := @fin_choice _ (fun _ => 0) _ n.+1 B.
have i_n : (i < n)%N by apply: leq_trans ik kn.
exists (fun l => G l i.+1), (fun l => H (n - l)%N i.+1); split; split.
- by move=> l ln; have [a _ _] := hG l ln; exact: a.
- have D e : derivative_right i.+1 (fun x => \sum_(0 <= l < n.+1) e l * value k l x) (t 0%N) (\sum_(0 <= l < n.+1) e l * G l i.+1).
    by apply: derivative_right_sum => l ln; have [a _ _] := hG l ln; exact: a.
  rewrite -(@end_sum _ (fun l => G l i.+1) d n i) //; first exact: D.
    apply: (derivative_right_unique (D (fun _ => 1))); apply: (derivative_right_ext U) (derivative_right_const i (t 0%N) 1) => x /andP[x1 x2].
    by rewrite -[LHS](S1 x) ?(ltW x1) ?(ltW x2) //; apply: eq_bigr => l _; rewrite mul1r.
  by move=> l /andP[l1 l2]; have [_ a _] := hG l l2; exact: a.
- by have [_ _ a] := hG i.+1 i_n; exact: a.
- by move=> l ln; have [|a _ _] := hH (n - l)%N; [rewrite ltnS leq_subr|rewrite subKn // in a; exact: a].
- have D e : derivative_left i.+1 (fun x => \sum_(0 <= l < n.+1) e l * value k l x) (t m) (\sum_(0 <= l < n.+1) e (n - l)%N * H l i.+1).
    have : derivative_left i.+1 (fun x => \sum_(0 <= l < n.+1) e (n - l)%N * value k (n - l) x) (t m) (\sum_(0 <= l < n.+1) e (n - l)%N * H l i.+1).
      by apply: (@derivative_left_sum R i (fun l => value k (n - l))) => l ln; have [a _ _] := hH l ln; exact: a.
    apply: (derivative_left_ext U) => x _; rewrite [RHS]big_nat_rev /=; by apply: eq_bigr => l _; rewrite add0n subSS.
  have -> : \sum_(1 <= l < i.+2) H (n - (n - l))%N i.+1 * (d (n - l)%N - d n) = \sum_(1 <= l < i.+2) H l i.+1 * (d (n - l)%N - d (n - 0)%N).
    apply: eq_big_nat => l /andP[_ hl]; rewrite subn0 subKn //; apply: leq_trans i_n; by rewrite -ltnS.
  rewrite -(@end_sum _ (fun l => H l i.+1) (fun l => d (n - l)%N) n i) //; first exact: D.
    apply: (derivative_left_unique (D (fun _ => 1))); apply: (derivative_left_ext U) (derivative_left_const i (t m) 1) => x /andP[x1 x2].
    by rewrite -[LHS](S1 x) ?(ltW x1) ?(ltW x2) //; apply: eq_bigr => l _; rewrite mul1r.
  by move=> l /andP[l1 l2]; have [_ a _] := hH l l2; exact: a.
by have [_ _ a] := hH i.+1 i_n; rewrite subKn //; exact: a.
Qed.
End Statements.

(* P4.2.tangent as printed is false for every degree: d_0 = d_1 <> d_2, on the knots 0 (k+1 times), 1, 2 (k+1 times), n = k+1 *)
Theorem P4_2_tangent_printed_false (R : realFieldType) (r : R) k : 0 < r -> (1 <= k)%N -> exists (t d : nat -> R) (n : nat),
  [/\ forall i, t i <= t i.+1, Uclamped t n k, exists i, (1 <= i <= n)%N /\ d i != d 0%N &
      right_taylor (curve_in r t n k d) (t 0%N) (d 0%N) 0].
Proof.
move=> r0 k1; pose t i : R := if (i <= k)%N then 0 else if (i <= k.+1)%N then 1 else 2%:R.
have m0 i : t i <= t i.+1.
  rewrite /t; case: (leqP i.+1 k) => a; first by rewrite (ltnW a) lexx.
  case: (leqP i k) => b; first by case: ifP => _; rewrite ?ler01 ?ler0n.
  by rewrite [(i.+1 <= k.+1)%N]leqNgt ltnS b /=; case: ifP => _; rewrite ?ler1n ?lexx.
exists t, (fun i => (i == 2)%N%:R), k.+1.
have e0 : t 0%N = 0 by []. have ek : t k = 0 by rewrite /t leqnn.
have e1 : t k.+1 = 1 by rewrite /t ltnn leqnn.
have e2 j : (k.+1 < j)%N -> t j = 2%:R by move=> h; rewrite /t leqNgt (ltnW h) /= leqNgt h.
have hc : Uclamped t k.+1 k.
  split; [split|by rewrite ek e1 ltr01|by rewrite e1 e2 // ltr1n]; rewrite ?ek ?e0 //.
    by rewrite !e2 //; clear; lia.
  by rewrite e2 // ltr0n.
split=> //; first by exists 2%N; split; [exact: k1|rewrite eqxx mulr1n mulr0n oner_neq0].
have [h _] := P4_2_2_amended r0 m0 (Uopen_t0 (let: And3 a _ _ := hc in a)) (fun i => (i == 2)%N%:R) k1 hc.
by move: h; rewrite subrr mulr0.
Qed.
