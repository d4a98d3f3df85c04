(* A positive weight at every knot: rise : fall = omega_(i+d) (x - t_i) : omega_i (t_(i+d) - x) on [t_i,t_(i+d)]. These functions are as
   smooth at a knot as polynomial B-splines, those of all weights 1: of class C^(k-q) at q copies of a knot, and not smoother. With
   the moved knots s_j(x) = (t_j - x)/omega_j a weight is -s_i/(s_(i+d) - s_i), so that T_i = G_i + G_(i+1) + .. is a divided
   difference of a truncated power; what changes of it at a knot is one of a power at the copies of the knot. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values Cumulative RationalDerivative HigherDerivatives.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- divided differences of powers, without a quotient: E e d i is that of z^(d+e) at s_i, .., s_(i+d), if E 0 d i is that of z^d ---- *)
Section Powers.
Variable R : comRingType.
Variables (s : nat -> R) (T : nat -> nat -> R).
Fixpoint E (e : nat) : nat -> nat -> R := if e is e'.+1 then
  (fix F d i := if d is d'.+1 then s i * E e' d i + F d' i.+1 else s i * E e' 0%N i) else T.
Lemma E0 d i : E 0 d i = T d i. Proof. by []. Qed.
Lemma ES0 e i : E e.+1 0 i = s i * E e 0 i. Proof. by []. Qed.
Lemma ES e d i : E e.+1 d.+1 i = s i * E e d.+1 i + E e.+1 d i.+1. Proof. by []. Qed.
Variable K : nat.
Hypothesis T_step : forall d i, (d < K)%N -> (s (i + d.+1)%N - s i) * T d.+1 i = s (i + d.+1)%N * T d i.+1 - s i * T d i.
Theorem E_step e d i : (d < K)%N -> (s (i + d.+1)%N - s i) * E e d.+1 i = E e.+1 d i.+1 - E e.+1 d i.
Proof.
have L2 e' d' i' : (s (i' + d'.+1)%N - s i') * E e' d'.+1 i' = E e'.+1 d' i'.+1 - E e'.+1 d' i' ->
    E e'.+1 d'.+1 i' = s (i' + d'.+1)%N * E e' d'.+1 i' + E e'.+1 d' i'.
  by move=> h; rewrite ES -[E e'.+1 d' i'.+1](subrK (E e'.+1 d' i')) -h; ring.
elim: e d i => [|e IHe] d; elim: d => [|d IH] i dK.
- by rewrite !ES0 !E0 T_step // addn1.
- by rewrite (L2 0%N d i.+1 (IH i.+1 (ltnW dK))) ES !E0 T_step // addSnnS; ring.
- rewrite ES mulrDr mulrCA IHe // !ES0 addn1; ring.
rewrite (L2 e.+1 d i.+1 (IH i.+1 (ltnW dK))) [E e.+2 d.+1 i]ES [E e.+1 d.+2 i]ES mulrDr mulrCA IHe // addSnnS; ring.
Qed.
End Powers.

Section KnotWeights.
Variable R : realFieldType.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variable om : nat -> R.
Hypothesis om0 : forall i, 0 < om i.
(* the weight, everywhere and on [t_i,t_(i+d)) *)
Definition L i j (x : R) : R := om j * (x - t i) + om i * (t j - x).
Definition ow d i (x : R) : R := om (i + d)%N * (x - t i) / L i (i + d) x.
Definition owt d i (x : R) : R := if t i <= x < t (i + d)%N then ow d i x else 0.
Lemma owt_in d i x : t i <= x < t (i + d)%N -> owt d i x = ow d i x.
Proof. by rewrite /owt => ->. Qed.
Lemma L_gt0 i j x : t i <= x -> x <= t j -> t i < t j -> 0 < L i j x.
Proof.
move=> h1 h2 h; rewrite /L; case: (ltP (t i) x) => c.
  by rewrite ltr_paddr ?mulr_ge0 ?subr_ge0 ?(ltW (om0 _)) // mulr_gt0 ?subr_gt0.
by rewrite ltr_paddl ?mulr_ge0 ?subr_ge0 ?(ltW (om0 _)) // mulr_gt0 ?subr_gt0 // (le_lt_trans c).
Qed.
Lemma ow_left d i : t i < t (i + d)%N -> ow d i (t i) = 0.
Proof. by move=> _; rewrite /ow subrr mulr0 mul0r. Qed.
Lemma ow_right d i : t i < t (i + d)%N -> ow d i (t (i + d)%N) = 1.
Proof. by move=> h; rewrite /ow /L subrr mulr0 addr0 divff // mulf_neq0 ?gt_eqF // subr_gt0. Qed.

(* the moved knots *)
Definition sk j (x : R) : R := (t j - x) / om j.
Lemma sk_L i j x : sk j x - sk i x = L i j x / (om i * om j).
Proof. by rewrite /sk /L; field; rewrite !gt_eqF. Qed.
Lemma ow_step d i x (a b : R) : L i (i + d) x != 0 ->
  (sk (i + d) x - sk i x) * (ow d i x * a + (1 - ow d i x) * b) = sk (i + d) x * b - sk i x * a.
Proof.
move=> n; rewrite sk_L /ow /sk; move: (n); rewrite /L; have o1 := om0 i; have o2 := om0 (i + d).
move: (om i) (om (i + d)%N) (t i) (t (i + d)%N) o1 o2 => o p u v o1 o2 n'.
by field; rewrite n' !gt_eqF.
Qed.

(* ---- a knot y with the copies t_(p+1), .., t_(p+q) ---- *)
Section Knot.
Variables (p q K : nat) (y : R).
Hypothesis q0 : (0 < q)%N.
Hypothesis hL : t p < y.
Hypothesis hy : forall j, (p < j <= p + q)%N -> t j = y.
Hypothesis hR : y < t (p + q).+1.
Definition TL d i x : R := T (fun e j => ow e j x) p d i.
Definition TR d i x : R := T (fun e j => ow e j x) (p + q) d i.
Lemma left_knot j : (j <= p)%N -> t j < y.
Proof. by move=> h; apply: le_lt_trans (tle h) hL. Qed.
Lemma right_knot j : (p + q < j)%N -> y < t j.
Proof. by move=> h; apply: lt_le_trans hR (tle h). Qed.
Lemma knot_le j : (j <= p + q)%N -> t j <= y.
Proof. by case: (leqP j p) => h h'; [exact/ltW/left_knot|rewrite hy // h]. Qed.
Lemma knot_ge j : (p < j)%N -> y <= t j.
Proof. by case: (leqP j (p + q)) => h h'; [rewrite hy // h'|exact/ltW/right_knot]. Qed.
(* the intervals whose weights are used on the two spans beside y *)
Definition used i d := ((i <= p < i + d) || (i <= p + q < i + d))%N.
Lemma used_L i d : used i d -> L i (i + d) y != 0.
Proof.
move=> /orP[|] /andP[h1 h2]; rewrite gt_eqF // L_gt0 ?knot_le ?knot_ge //; try (move: h1 h2; clear; lia).
  by apply: lt_le_trans (left_knot h1) _; apply: knot_ge.
by apply: le_lt_trans (knot_le h1) _; apply: right_knot.
Qed.
(* the product of their denominators *)
Definition Lp i j : {poly R} := (om j)%:P * ('X - (t i)%:P) + (om i)%:P * ((t j)%:P - 'X).
Lemma LpE i j x : (Lp i j).[x] = L i j x.
Proof. by rewrite /Lp /L !hE. Qed.
Definition Wp : {poly R} := \prod_(i < (p + q).+1) \prod_(d < K.+2) (if used i d then Lp i (i + d) else 1).
Lemma Wp_near : Wp.[y] != 0.
Proof.
rewrite /Wp horner_prod; apply/prodf_neq0 => i _; rewrite horner_prod; apply/prodf_neq0 => d _.
by case: ifP => [h|_]; [rewrite LpE used_L|rewrite hornerC oner_neq0].
Qed.
Lemma Wp_used x i d : Wp.[x] != 0 -> used i d -> (d <= K.+1)%N -> L i (i + d) x != 0.
Proof.
rewrite /Wp horner_prod => /prodf_neq0 h u dK; have ip : (i < (p + q).+1)%N by move: u; rewrite /used; clear; lia.
have := h (Ordinal ip) isT; rewrite horner_prod => /prodf_neq0 h'; have := h' (Ordinal (dK : (d < K.+2)%N)) isT.
by rewrite /= u LpE.
Qed.

(* the recursion of T, in the moved knots, on both spans *)
Lemma T_span s d i x : (s == p) || (s == p + q)%N -> Wp.[x] != 0 -> (d <= K)%N ->
  (sk (i + d.+1) x - sk i x) * T (fun e j => ow e j x) s d.+1 i =
  sk (i + d.+1) x * T (fun e j => ow e j x) s d i.+1 - sk i x * T (fun e j => ow e j x) s d i.
Proof.
move=> hs wx dK; case: (leqP i s) => is_; last by rewrite !T_high ?mulr0 ?subr0 // leqW.
case: (ltnP s (i + d.+1)) => sd; last first.
  by rewrite !T_low ?mulr1 //; move: sd; clear; lia.
rewrite TS ow_step //; apply: (Wp_used wx) => //.
by rewrite /used; case/orP: hs => /eqP <-; rewrite is_ sd ?orbT.
Qed.
Definition JT x d i : R := TR d i x - TL d i x.
Definition Ex e d i x : R := E (fun j => sk j x) (JT x) e d i.
Lemma JT_step x d i : Wp.[x] != 0 -> (d < K.+1)%N ->
  (sk (i + d.+1) x - sk i x) * JT x d.+1 i = sk (i + d.+1) x * JT x d i.+1 - sk i x * JT x d i.
Proof.
move=> wx dK; rewrite /JT /TR /TL mulrBr !T_span ?eqxx ?orbT //.
move: (T _ _ d i) (T _ _ d i) (T _ _ d i.+1) (T _ _ d i.+1) => a b u v; ring.
Qed.
Lemma Ex_step e d i x : Wp.[x] != 0 -> (d < K.+1)%N -> (sk (i + d.+1) x - sk i x) * Ex e d.+1 i x = Ex e.+1 d i.+1 x - Ex e.+1 d i x.
Proof. by move=> wx dK; apply: (@E_step R _ (JT x) K.+1) => // d' i'; apply: JT_step. Qed.
(* no copy among i, .., i+d: nothing changes at y *)
Lemma Ex_none e d i x : (i + d <= p)%N || (p + q < i)%N -> Ex e d i x = 0.
Proof.
move=> h; rewrite /Ex; elim: e d i h => [|e IH] d i h.
  rewrite /= /JT /TR /TL; case/orP: h => h; last by rewrite !T_high ?subrr // (leq_ltn_trans (leq_addr _ _) h).
  by rewrite !T_low ?subrr // (leq_trans h) ?leq_addr.
elim: d i h => [|d IHd] i h; first by rewrite ES0 IH // mulr0.
by rewrite ES IH // mulr0 add0r IHd //; move: h; clear; lia.
Qed.
Definition sgn_ok (a : nat) (b : R) := 0 < (-1) ^+ a * b.
Lemma sgn_okD a b c : sgn_ok a b -> sgn_ok a c -> sgn_ok a (b + c).
Proof. by rewrite /sgn_ok mulrDr; apply: addr_gt0. Qed.
Lemma sk_copy j : (p < j <= p + q)%N -> leading y 1 (sk j) (- (om j)^-1).
Proof.
move=> h; exists (- (om j)^-1)%:P, 1; rewrite !hornerC divr1; split => //; first exact: oner_neq0.
by move=> x _; rewrite /sk (hy h) !hornerC divr1 expr1 mulrN -mulNr opprB.
Qed.
(* copies only: a positive multiple of (y - x)^e *)
Lemma Ex_copies e d i : (p < i)%N -> (i + d <= p + q)%N -> exists2 a, leading y e (Ex e d i) a & sgn_ok e a.
Proof.
elim: e d i => [|e IHe] d i hi hd.
  exists 1; last by rewrite /sgn_ok mulr1 expr0 ltr01.
  apply: (leading_ext _ (leading_const y 1)) => x; rewrite /Ex /= /JT /TR /TL T_low // T_high ?subr0 //.
have S d' i' : (p < i')%N -> (i' + d' <= p + q)%N -> exists2 a, leading y e.+1 (fun x => sk i' x * Ex e d' i' x) a & sgn_ok e.+1 a.
  move=> hi' hd'; have [a h1 h2] := IHe d' i' hi' hd'.
  have hc : (p < i' <= p + q)%N by move: hi' hd'; clear; lia.
  exists (- (om i')^-1 * a); first exact: (leading_mul (sk_copy hc) h1).
  by rewrite /sgn_ok exprS mulN1r mulNr mulNr mulrN opprK mulrCA mulr_gt0 ?invr_gt0.
elim: d i hi hd => [|d IHd] i hi hd; first exact: S.
have [a a1 a2] := S d.+1 i hi hd; have [b b1 b2] := IHd i.+1 (leqW hi) ltac:(by rewrite addSnnS).
by exists (a + b); [exact: leading_add a1 b1|exact: sgn_okD].
Qed.
(* the copies and the knots on the right among i, .., i+d *)
Definition cp i d := ((minn (i + d) (p + q)).+1 - maxn i p.+1)%N.
Definition rt i d := ((i + d).+1 - maxn (p + q).+1 i)%N.
Definition Dp i j : {poly R} := (om j)^-1%:P * ((t j)%:P - 'X) - (om i)^-1%:P * ((t i)%:P - 'X).
Lemma DpE i j x : (Dp i j).[x] = sk j x - sk i x.
Proof. by rewrite /Dp /sk !hE mulrC; congr (_ - _); rewrite mulrC. Qed.
Lemma Dp_gt0 i j : (i <= p + q)%N -> (p < j)%N -> (i <= p)%N || (p + q < j)%N -> 0 < (Dp i j).[y].
Proof.
move=> h1 h2 h3; rewrite DpE sk_L divr_gt0 ?mulr_gt0 // L_gt0 ?knot_le ?knot_ge //.
by case/orP: h3 => h; [apply: lt_le_trans (left_knot h) (knot_ge h2)|apply: le_lt_trans (knot_le h1) (right_knot h)].
Qed.
(* what changes at y is (y - x)^(e+d+1-c) times a function that has the sign of (-1)^(number of knots on the right) at y *)
Theorem Ex_lead d e i : (d <= K.+1)%N -> (i <= p + q)%N -> (p < i + d)%N ->
  exists2 a, leading y (e + d.+1 - cp i d) (Ex e d i) a & sgn_ok (e + d.+1 - cp i d + rt i d) a.
Proof.
have all d' e' i' : (p < i')%N -> (i' + d' <= p + q)%N ->
    exists2 a, leading y (e' + d'.+1 - cp i' d') (Ex e' d' i') a & sgn_ok (e' + d'.+1 - cp i' d' + rt i' d') a.
  move=> h1 h2; have [a a1 a2] := Ex_copies e' h1 h2.
  have -> : (e' + d'.+1 - cp i' d' = e')%N by rewrite /cp; move: h1 h2; clear; lia.
  have -> : (rt i' d' = 0)%N by rewrite /rt; move: h1 h2; clear; lia.
  by exists a; rewrite ?addn0.
elim: d e i => [|d IH] e i dK hi hd; first by apply: all; move: hi hd; clear; lia.
case: (boolP ((p < i)%N && (i + d.+1 <= p + q)%N)) => [/andP[h1 h2]|nc]; first exact: all.
have D0 : 0 < (Dp i (i + d.+1)).[y].
  by apply: Dp_gt0 => //; move: nc; rewrite negb_and -leqNgt -ltnNge.
set M := (e + d.+2 - cp i d.+1)%N; set N := rt i d.+1.
suff [b b1 b2] : exists2 b, leading y M (fun x => Ex e.+1 d i.+1 x - Ex e.+1 d i x) b & sgn_ok (M + N) b.
  exists (b / (Dp i (i + d.+1)).[y]); last by rewrite /sgn_ok mulrA divr_gt0.
  by apply: (@leading_div _ y M _ Wp _ _ b _ Wp_near) b1 => [|x wx]; [rewrite gt_eqF|rewrite DpE Ex_step].
have weak e' i' : (M < e' + d.+1 - cp i' d)%N || ((i' + d <= p) || (p + q < i'))%N -> leading y M (Ex e' d i') 0.
  move=> h; case: (boolP ((i' + d <= p) || (p + q < i'))%N) => n.
    by apply: (leading_ext _ (leading0 y M)) => x; rewrite Ex_none.
  have lt : (M < e' + d.+1 - cp i' d)%N by case/orP: h => // h; rewrite h in n.
  move: n; rewrite negb_or -!ltnNge ltnS => /andP[n1 n2].
  by have [a h1 _] := IH e' i' (ltnW dK) n2 n1; apply: leading_lt h1.
have A : (i <= p)%N -> exists2 a, leading y M (Ex e.+1 d i.+1) a & sgn_ok (M + N) a.
  move=> h; have [|a a1 a2] := IH e.+1 i.+1 (ltnW dK) ltac:(move: h q0; clear; lia); first by rewrite addSnnS.
  have E1 : (e.+1 + d.+1 - cp i.+1 d = M)%N by rewrite /M /cp; move: h; clear; lia.
  have E2 : (rt i.+1 d = N)%N by rewrite /N /rt; move: h; clear; lia.
  by exists a; rewrite -?E2 -E1.
have B : (p + q < i + d.+1)%N -> exists2 a, leading y M (Ex e.+1 d i) a & sgn_ok (M + N) (- a).
  move=> h; have [|a a1 a2] := IH e.+1 i (ltnW dK) hi; first by move: h q0; clear; lia.
  have E1 : (e.+1 + d.+1 - cp i d = M)%N by rewrite /M /cp; move: h; clear; lia.
  have E2 : ((rt i d).+1 = N)%N by rewrite /N /rt; move: h hi; clear; lia.
  exists a; first by rewrite -E1.
  by rewrite -E2 addnS -E1 /sgn_ok exprS mulN1r mulNr mulrN opprK.
move: nc; rewrite negb_and -leqNgt -ltnNge; case: (leqP i p) => h1; case: (leqP (i + d.+1) (p + q)) => h2 // _.
- have [a a1 a2] := A h1; exists (a - 0); last by rewrite subr0.
  by apply: leading_sub => //; apply: weak; rewrite /M /cp; move: h1 h2 hd; clear; lia.
- have [a a1 a2] := A h1; have [b b1 b2] := B h2; exists (a - b); first exact: leading_sub.
  exact: sgn_okD.
have [b b1 b2] := B h2; exists (0 - b); last by rewrite sub0r.
by apply: leading_sub => //; apply: weak; rewrite /M /cp; move: h1 h2 hd hi; clear; lia.
Qed.

(* the functions on both sides of y, and what changes of them *)
Local Notation Gw := (G owt t).
Lemma ow_quotient s d j : (s == p) || (s == p + q)%N -> (j <= s < j + d)%N -> quotient_at y (ow d j).
Proof.
move=> hs hj; have u : used j d by rewrite /used; case/orP: hs => /eqP <-; rewrite hj ?orbT.
exists ((om (j + d)%N)%:P * ('X - (t j)%:P)), (Lp j (j + d)); rewrite LpE used_L //; split => // x _.
by rewrite LpE /ow !hE.
Qed.
Lemma G_side s k i x : t s <= x < t s.+1 -> Gw k i x = N (fun d j => ow d j x) s k i.
Proof. by move=> hx; apply: (@G_piece R owt ow t t_mono) => // d j z; exact: owt_in. Qed.
Lemma last_copy : t (p + q)%N = y.
Proof. by apply: hy; move: q0; clear; lia. Qed.
Lemma first_copy : t p.+1 = y.
Proof. by apply: hy; move: q0; clear; lia. Qed.
Lemma sides k i M a : leading y M (fun x => JT x k i - JT x k i.+1) a -> exists F F',
  [/\ forall e, derivative_left e (Gw k i) y (F e), forall e, derivative_right e (Gw k i) y (F' e),
      forall e, (e < M)%N -> F e = F' e & F' M - F M = M`!%:R * a].
Proof.
move=> ha.
have [P1 [Q1 [n1 e1]]] := N_quotient k i (fun d j => @ow_quotient p d j ltac:(by rewrite eqxx)).
have [P2 [Q2 [n2 e2]]] := N_quotient k i (fun d j => @ow_quotient (p + q)%N d j ltac:(by rewrite eqxx orbT)).
have [|j1 j2] := @leading_jump R y M P1 Q1 P2 Q2 a n1 n2.
  apply: (@leading_near R (Q1 * Q2) _ _ _ _ _ _ _ ha); first by rewrite hornerM mulf_neq0.
  move=> x; rewrite hornerM mulf_eq0 negb_or => /andP[x1 x2]; rewrite -e1 // -e2 // !N_T /JT /TR /TL.
  by move: (T _ _ k i) (T _ _ k i) (T _ _ k i.+1) (T _ _ k i.+1) => b c u v; ring.
exists (fun e => Dq P1 Q1 e y), (fun e => Dq P2 Q2 e y); split => // e.
  have [d d0 hd] := poly_near0 n1; have d1 : 0 < Num.min d (y - t p) by rewrite lt_minr d0 subr_gt0.
  apply: (quotient_left d1 n1) => x /andP[x1 x2].
  move: x1; rewrite ltr_subl_addr -ltr_subl_addl lt_minr => /andP[a1 a2].
  rewrite (@G_side p); last by rewrite first_copy x2 andbT ltW //; move: a2; rewrite ltr_add2l ltr_opp2.
  by apply: e1; apply: hd; rewrite (lt_trans x2) ?ltr_addl // andbT ltr_subl_addr -ltr_subl_addl.
have [d d0 hd] := poly_near0 n2; have d1 : 0 < Num.min d (t (p + q).+1 - y) by rewrite lt_minr d0 subr_gt0.
apply: (quotient_right d1 n2) => x /andP[x1 x2].
move: x2; rewrite -ltr_subl_addl lt_minr => /andP[a1 a2].
rewrite (@G_side (p + q)); last by rewrite last_copy ltW //=; move: a2; rewrite ltr_add2r.
by apply: e2; apply: hd; rewrite -ltr_subl_addl a1 andbT (lt_trans _ x1) // ltr_subl_addr ltr_addl.
Qed.
(* derivatives of order at most k - q agree *)
Theorem knot_smooth i e : (e + q <= K.+1)%N -> exists v, derivative_left e (Gw K.+1 i) y v /\ derivative_right e (Gw K.+1 i) y v.
Proof.
move=> eq; have h i' : exists a, leading y (K.+2 - q) (fun x => JT x K.+1 i') a.
  case: (boolP ((i' + K.+1 <= p) || (p + q < i'))%N) => n.
    by exists 0; apply: (leading_ext _ (leading0 y _)) => x; rewrite -(@Ex_none 0 K.+1 i' x n).
  move: n; rewrite negb_or -!ltnNge ltnS => /andP[n1 n2].
  have [a h1 _] := Ex_lead 0 (leqnn K.+1) n2 n1; rewrite add0n in h1.
  have : (K.+2 - q <= K.+2 - cp i' K.+1)%N by rewrite /cp; clear; lia.
  rewrite leq_eqVlt => /orP[/eqP ->|lt]; first by exists a.
  by exists 0; apply: leading_lt lt h1.
have [a ha] := h i; have [b hb] := h i.+1.
have [F [F' [h1 h2 h3 _]]] := sides (leading_sub ha hb).
exists (F e); split => //; rewrite h3 //; move: eq; clear; lia.
Qed.
(* and that of the next order jumps, for every function with y inside of its support *)
Theorem knot_jump i : t i < y < t (i + K.+2)%N -> exists v v',
  [/\ derivative_left (K.+2 - q) (Gw K.+1 i) y v, derivative_right (K.+2 - q) (Gw K.+1 i) y v' & v != v'].
Proof.
move=> /andP[h1 h2].
have ip : (i <= p)%N by rewrite leqNgt; apply/negP => /knot_ge; rewrite leNgt h1.
have ik : (p + q < i + K.+2)%N by rewrite ltnNge; apply/negP => /knot_le; rewrite leNgt h2.
have [|a a1 a2] := @Ex_lead K.+1 0 i (leqnn _) (leq_trans ip (leq_addr _ _)); first by move: ik q0; clear; lia.
have [||b b1 b2] := @Ex_lead K.+1 0 i.+1 (leqnn _); [by move: ip q0; clear; lia|by move: ik q0; clear; lia|].
have E1 : (0 + K.+2 - cp i K.+1 = K.+2 - q)%N by rewrite /cp; move: ip ik; clear; lia.
have E2 : (0 + K.+2 - cp i.+1 K.+1 = K.+2 - q)%N by rewrite /cp; move: ip ik; clear; lia.
have E3 : (rt i.+1 K.+1 = (rt i K.+1).+1)%N by rewrite /rt; move: ip ik; clear; lia.
rewrite E1 in a1 a2; rewrite E2 E3 addnS in b1 b2.
have b3 : sgn_ok (K.+2 - q + rt i K.+1) (- b) by move: b2; rewrite /sgn_ok exprS mulN1r mulNr mulrN.
have ab : a - b != 0.
  by have := sgn_okD a2 b3; rewrite /sgn_ok; apply: contraTneq => ->; rewrite mulr0 ltxx.
have [F [F' [l1 l2 _ l4]]] := sides (leading_sub a1 b1).
exists (F (K.+2 - q)%N), (F' (K.+2 - q)%N); split => //.
by rewrite eq_sym -subr_eq0 l4 mulf_neq0 // pnatr_eq0 -lt0n fact_gt0.
Qed.
End Knot.

Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Local Notation Gw := (G owt t).
Lemma mult_gt0 (b j : nat) : t 0%N < t j < t b -> (0 < mult t b (t j))%N.
Proof.
move=> /andP[h0 hm]; rewrite /mult -has_count; apply/hasP; exists j; last exact: eqxx.
by rewrite mem_iota /= ltnS ltnW // (t_lt_ltn t_mono).
Qed.
(* KW3.2: at a knot of p copies inside, the derivatives of order at most k - p from the left and from the right are the same *)
Theorem KW3_2_printed i j q : (1 <= k)%N -> (i <= n)%N -> t 0%N < t j < t m -> (q + mult t m (t j) <= k)%N ->
  exists v, derivative_left q (Gw k i) (t j) v /\ derivative_right q (Gw k i) (t j) v.
Proof.
case: k => // K _ im hj hq; have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hj.
have q0 := mult_gt0 hj; exact: (@knot_smooth p _ K (t j) q0 p1 p2 p3).
Qed.
(* KW3.3: of order k - p + 1 they are not, for every function with the knot inside of its support *)
Theorem KW3_3_printed i j q : (i <= n)%N -> (1 <= q <= k)%N -> t 0%N < t j < t m -> t i < t j < t (i + k.+1)%N ->
  (q + mult t m (t j) = k.+1)%N -> exists v v', [/\ derivative_left q (Gw k i) (t j) v, derivative_right q (Gw k i) (t j) v' & v != v'].
Proof.
case: k => [|K] im /andP[q1 qk] hj hi hq; first by move: q1 qk; clear; lia.
have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hj; have q0 := mult_gt0 hj.
have -> : q = (K.+2 - mult t (n + K.+2) (t j))%N by move: (mult _ _ _) hq => mu hq; rewrite -hq addnK.
exact: (@knot_jump p _ K (t j) q0 p1 p2 p3).
Qed.
End KnotWeights.
