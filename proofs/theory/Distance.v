(* X.close: how far a curve is from the classical one, and from that for another index. One step of the recursion adds at most the
   largest difference of two weights, because the weights fall with their index. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Values StatementsBasis StatementsDerivatives StatementsCurves Cumulative.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Steps.
Variable R : realFieldType.
Lemma sum_mix (c e : nat -> R) b : (forall i, 0 <= c i <= 1) -> (forall i, c i.+1 <= c i) -> (forall i, 0 <= e i) ->
  \sum_(0 <= i < b.+1) (c i * e i + (1 - c i) * e i.+1) <= \sum_(0 <= i < b.+1) e i + (1 - c b) * e b.+1.
Proof.
move=> h01 hc he; elim: b => [|b IH].
  rewrite !big_nat1 ler_add2r -[X in _ <= X]mul1r ler_wpmul2r //; by case/andP: (h01 0%N).
rewrite big_nat_recr //= [X in _ <= X + _]big_nat_recr //= addrA ler_add2r.
apply: le_trans (ler_add IH (lexx _)) _; rewrite -addrA ler_add2l -mulrDl.
by rewrite -[X in _ <= X]mul1r ler_wpmul2r // -subr_ge0 opprD opprB addrA [1 + _]addrC subrK subr_ge0.
Qed.

Variables (w w' : nat -> nat -> R) (s : nat) (D : R).
Local Notation inside d i := (i <= s < i + d)%N.
Hypothesis D0 : 0 <= D.
Hypothesis h : forall e j, inside e j -> 0 <= w e j <= 1.
Hypothesis h' : forall e j, inside e j -> 0 <= w' e j <= 1.
Hypothesis hD : forall e j, inside e j -> `|w' e j - w e j| <= D.
Hypothesis fall : forall e j, inside e j -> inside e j.+1 -> w' e j.+1 <= w' e j.
Let c d i : R := if inside d i then w' d i else (i <= s)%N%:R.
Lemma c01 d i : 0 <= c d i <= 1.
Proof. by rewrite /c; case: ifP => [/h'//|_]; rewrite ler0n lern1 leq_b1. Qed.
Lemma c_fall d i : c d i.+1 <= c d i.
Proof.
rewrite {1}/c; case: ifP => [hi|hi].
  rewrite /c; case: ifP => [hj|hj]; first exact: fall.
  have -> : (i <= s)%N by move: hi; clear; lia.
  by have /andP[] := h' hi.
case: (leqP i.+1 s) => is_; last by case/andP: (c01 d i).
rewrite /c; case: ifP => [hj|_]; last by rewrite ltnW.
by move: hi hj is_; clear; lia.
Qed.
(* the sum of all |T' - T| is at most d times the largest difference of two weights *)
Theorem T_distance d b : (s < b)%N -> \sum_(0 <= i < b) `|T w' s d i - T w s d i| <= d%:R * D.
Proof.
case: b => // b sb; elim: d => [|d IH].
  by rewrite mul0r big1 // => i _; rewrite subrr normr0.
pose e i := `|T w' s d i - T w s d i|.
have step i : `|T w' s d.+1 i - T w s d.+1 i| <= (c d.+1 i * e i + (1 - c d.+1 i) * e i.+1) + D * N w s d i.
  have /andP[a1 a2] := c01 d.+1 i; have n0 : 0 <= N w s d i by apply: N_ge0.
  case: (boolP (inside d.+1 i)) => hi; last first.
    have -> : T w' s d.+1 i - T w s d.+1 i = 0.
      case: (ltnP s i) => si; first by rewrite !T_high // subrr.
      by rewrite !T_low ?subrr //; move: hi si; clear; lia.
    by rewrite normr0 !addr_ge0 // mulr_ge0 ?normr_ge0 ?subr_ge0.
  rewrite T_diff; have -> : c d.+1 i = w' d.+1 i by rewrite /c hi.
  have /andP[b1 b2] := h' hi.
  apply: le_trans (ler_norm_add _ _) _; apply: ler_add.
    apply: le_trans (ler_norm_add _ _) _; by rewrite !normrM (ger0_norm b1) (@ger0_norm _ (1 - w' d.+1 i)) ?subr_ge0.
  by rewrite normrM (ger0_norm n0) ler_wpmul2r // hD.
have eb : e b.+1 = 0 by rewrite /e !T_high ?subrr ?normr0 // ltnW.
apply: (@le_trans _ _ (\sum_(0 <= i < b.+1) ((c d.+1 i * e i + (1 - c d.+1 i) * e i.+1) + D * N w s d i))).
  by apply: ler_sum => i _; exact: step.
have -> : d.+1%:R * D = d%:R * D + D by rewrite -[d.+1]addn1 natrD mulrDl mul1r.
rewrite big_split /=; apply: ler_add.
  have mix := @sum_mix (c d.+1) e b (c01 d.+1) (c_fall d.+1) (fun i => normr_ge0 _).
  by apply: (le_trans mix); rewrite eb mulr0 addr0.
rewrite -mulr_sumr (T_sum w d sb) // -[X in _ <= X]mulr1 ler_wpmul2l //.
by case/andP: (@T_01 R w s d 0%N h).
Qed.
End Steps.

(* the weights fall with their index *)
Lemma mob_ab (R : realFieldType) (r x a b a' b' : R) : 0 < r -> a <= a' -> b <= b' -> a' <= x -> x <= b -> a < b -> a' < b' ->
  mob r x a' b' <= mob r x a b.
Proof.
move=> r0 aa bb ax xb ab ab'; have d1 := mob_den_gt0 r0 (le_trans aa ax) xb ab; have d2 := mob_den_gt0 r0 ax (le_trans xb bb) ab'.
rewrite /mob ler_pdivr_mulr // mulrAC ler_pdivl_mulr // -subr_ge0.
have -> : r * (x - a) * (r * (x - a') + (b' - x)) - r * (x - a') * (r * (x - a) + (b - x)) =
  r * ((x - a') * (b' - b) + (a' - a) * (b' - x)) by ring.
by rewrite mulr_ge0 ?(ltW r0) // addr_ge0 // mulr_ge0 ?subr_ge0 // (le_trans xb).
Qed.

(* with one weight c over the whole span the sum of all T_i is known *)
Lemma T_sum_const (R : realFieldType) (w : nat -> nat -> R) (c : R) s d : (forall e j, (j <= s < j + e)%N -> (e <= d)%N -> w e j = c) -> (d <= s)%N ->
  \sum_(0 <= i < s.+1) T w s d i = s.+1%:R - d%:R * (1 - c).
Proof.
elim: d => [|d IH] h ds.
  rewrite mul0r subr0 (eq_big_nat _ _ (F2 := fun _ => 1)); last by move=> i /andP[_ hi] /=; rewrite -ltnS hi.
  by rewrite sumr_const_nat subn0.
rewrite (eq_big_nat _ _ (F2 := fun i => T w s d i - (1 - c) * (T w s d i - T w s d i.+1))); last first.
  move=> i /andP[_ hi]; case: (ltnP s (i + d.+1)) => lt.
    rewrite TS h //; last by rewrite -ltnS hi.
    by move: (T w s d i) (T w s d i.+1) => u v; ring.
  by rewrite !T_low ?subrr ?mulr0 ?subr0 //; move: lt; clear; lia.
rewrite sumrB -mulr_sumr IH; [|by move=> e j hj he; apply: h => //; exact: leqW|exact: ltnW].
rewrite (eq_bigr (fun i => - (T w s d i.+1 - T w s d i))); last by move=> i _; rewrite opprB.
rewrite sumrN telescope_sumr // T_high // T_low ?add0n ?(ltnW ds) // sub0r opprK mulr1.
by rewrite -[d.+1]addn1 natrD; move: (s.+1%:R) (d%:R) => u v; ring.
Qed.

Section Close.
Variable R : rcfType.
Definition delta (r : R) : R := `|Num.sqrt r - 1| / (Num.sqrt r + 1).
Lemma sqrt1_gt0 (r : R) : 0 < Num.sqrt r + 1.
Proof. by rewrite ltr_paddl ?sqrtr_ge0. Qed.
Lemma delta_ge0 (r : R) : 0 <= delta r.
Proof. by rewrite divr_ge0 ?normr_ge0 // ltW // sqrt1_gt0. Qed.
(* Ill2.1.crucial, its first line: no weight is farther than delta from the classical one *)
Theorem weight_distance (r x a b : R) : 0 < r -> a <= x -> x <= b -> a < b -> `|mob r x a b - mob 1 x a b| <= delta r.
Proof.
move=> r0 ax xb ab; have d1 := mob_den_gt0 r0 ax xb ab; have d2 := mob_den_gt0 (@ltr01 R) ax xb ab.
have q2 : Num.sqrt r ^+ 2 = r by rewrite sqr_sqrtr // ltW.
have q0 := sqrtr_ge0 r; have s0 := sqrt1_gt0 r; rewrite /delta.
move: (Num.sqrt r) q2 q0 s0 => q q2 q0 s0; rewrite -q2 in d1 *.
set u := x - a in d1 d2 *; set v := b - x in d1 d2 *.
rewrite mul1r in d2; have u0 : 0 <= u by rewrite subr_ge0. have v0 : 0 <= v by rewrite subr_ge0.
have -> : mob (q ^+ 2) x a b - mob 1 x a b = (q - 1) * ((q + 1) * (u * v)) / ((q ^+ 2 * u + v) * (u + v)).
  have n1 : q ^+ 2 * u + v != 0 by rewrite gt_eqF.
  have n2 : u + v != 0 by rewrite gt_eqF.
  by rewrite /mob -/u -/v mul1r; field; rewrite n1 n2.
rewrite normrM [X in _ * X <= _]gtr0_norm ?invr_gt0 ?mulr_gt0 // normrM [X in _ * X / _ <= _]ger0_norm; last by rewrite !mulr_ge0 // ltW.
rewrite ler_pdivr_mulr ?mulr_gt0 // mulrAC ler_pdivl_mulr // -mulrA; apply: ler_wpmul2l; first exact: normr_ge0.
rewrite -subr_ge0; have -> : (q ^+ 2 * u + v) * (u + v) - (q + 1) * (u * v) * (q + 1) = (q * u - v) ^+ 2 by ring.
exact: sqr_ge0.
Qed.

(* Ill2.1.crucial: the largest distance, the one point where it is taken, and what it is *)
Theorem Ill2_1_crucial_printed (r x a b : R) : 0 < r -> r != 1 -> a < b -> a < x < b ->
  [/\ `|phi r x a b - phi 1 x a b| <= delta r,
      `|phi r x a b - phi 1 x a b| = delta r <-> x = (a * Num.sqrt r + b) / (Num.sqrt r + 1) &
      delta r = 1 - 2%:R / (1 + Num.max (Num.sqrt r) (Num.sqrt r)^-1)].
Proof.
move=> r0 r1 ab /andP[ax xb]; have hx : a <= x < b by rewrite ltW.
rewrite !phi_in //; have d1 := mob_den_gt0 r0 (ltW ax) (ltW xb) ab; have d2 := mob_den_gt0 (@ltr01 R) (ltW ax) (ltW xb) ab.
have W := weight_distance r0 (ltW ax) (ltW xb) ab.
have q2 : Num.sqrt r ^+ 2 = r by rewrite sqr_sqrtr // ltW.
have q0 : 0 < Num.sqrt r by rewrite sqrtr_gt0.
have s0 := sqrt1_gt0 r; rewrite /delta in W *; move: (Num.sqrt r) q2 q0 s0 W => q q2 q0 s0 W.
have q1 : q - 1 != 0 by rewrite subr_eq0; apply: contraNneq r1 => e; rewrite -q2 e expr1n.
split=> //; last first.
  have qn : q != 0 by rewrite gt_eqF.
  case: (leP q 1) => h.
    have -> : Num.max q q^-1 = q^-1 by apply/max_idPr; apply: (le_trans h); rewrite invf_ge1.
    have -> : `|q - 1| = 1 - q by rewrite ler0_norm ?subr_le0 // opprB.
    have n : 1 + q != 0 by rewrite addrC gt_eqF.
    have n' : q + 1 != 0 by rewrite gt_eqF.
    by field; rewrite ?n ?n' ?qn.
  have -> : Num.max q q^-1 = q by apply/max_idPl; apply: le_trans (ltW h); rewrite invf_le1 // ltW.
  have n' : q + 1 != 0 by rewrite gt_eqF.
  have n : 1 + q != 0 by rewrite addrC.
  by rewrite gtr0_norm ?subr_gt0 //; field; rewrite ?n ?n'.
set u := x - a in d1 d2; set v := b - x in d1 d2.
have u0 : 0 < u by rewrite subr_gt0. have v0 : 0 < v by rewrite subr_gt0.
rewrite -q2 in d1 *; rewrite mul1r in d2.
have -> : mob (q ^+ 2) x a b - mob 1 x a b = (q - 1) * ((q + 1) * (u * v)) / ((q ^+ 2 * u + v) * (u + v)).
  have n1 : q ^+ 2 * u + v != 0 by rewrite gt_eqF.
  have n2 : u + v != 0 by rewrite gt_eqF.
  by rewrite /mob -/u -/v mul1r; field; rewrite n1 n2.
have D : 0 < (q ^+ 2 * u + v) * (u + v) by rewrite mulr_gt0.
rewrite !normrM [`|((q ^+ 2 * u + v) * (u + v))^-1|]gtr0_norm ?invr_gt0 // ![`|u|]gtr0_norm // ![`|v|]gtr0_norm // [`|q + 1|]gtr0_norm //.
have n0 : `|q - 1| != 0 by rewrite normr_eq0.
have K : (`|q - 1| * ((q + 1) * (u * v)) / ((q ^+ 2 * u + v) * (u + v)) = `|q - 1| / (q + 1)) <-> (q * u - v) ^+ 2 = 0.
  have sn : q + 1 != 0 by rewrite gt_eqF.
  have Dn : (q ^+ 2 * u + v) * (u + v) != 0 by rewrite gt_eqF.
  have e : (q * u - v) ^+ 2 = (q ^+ 2 * u + v) * (u + v) - (q + 1) * (u * v) * (q + 1) by ring.
  split=> h; last first.
    apply/eqP; rewrite eqr_div //; apply/eqP; rewrite -mulrA; congr (_ * _); apply/eqP; rewrite eq_sym -subr_eq0 -e h //.
  move/eqP: h; rewrite eqr_div // -mulrA => /eqP /(mulfI n0) h; by rewrite e h subrr.
rewrite K; split=> [/eqP|e].
  rewrite sqrf_eq0 subr_eq0 => /eqP h; apply: (mulIf (_ : q + 1 != 0)); first by rewrite gt_eqF.
  rewrite divfK ?gt_eqF //; move: h; rewrite /u /v => h.
  have -> : x * (q + 1) = q * (x - a) + (a * q + x) by ring.
  by rewrite h; ring.
by rewrite /u /v e; apply/eqP; rewrite sqrf_eq0; apply/eqP; field; rewrite gt_eqF.
Qed.

Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.
Variables n k : nat.
Local Notation m := (n + k.+1)%N.
Variable r : R.
Hypothesis r0 : 0 < r.
Lemma TT_distance s x : (s <= n)%N -> t s < t s.+1 -> t s <= x <= t s.+1 ->
  \sum_(1 <= i < n.+1) `|TT t s r k i x - TT t s 1 k i x| <= k%:R * delta r.
Proof.
move=> sn ss hx; have /andP[x1 x2] := hx.
have b1 e j : (j <= s < j + e)%N -> t j <= x by move=> /andP[a _]; exact: le_trans (tle a) x1.
have b2 e j : (j <= s < j + e)%N -> x <= t (j + e)%N by move=> /andP[_ a]; exact: le_trans x2 (tle a).
have := @T_distance R (fun e j => mw 1 t e j x) (fun e j => mw r t e j x) s (delta r) (delta_ge0 r)
  (fun e j => @span_01 R t t_mono s ss 1 x e j ltr01 hx) (fun e j => @span_01 R t t_mono s ss r x e j r0 hx) _ _ k n.+1 sn.
rewrite big_ltn // => H; apply: le_trans (H _ _); first by rewrite ler_addr normr_ge0.
  move=> e j hj; apply: weight_distance => //; [exact: b1 hj|exact: b2 hj|exact: (span_ab t_mono ss hj)].
move=> e j hj hj'; apply: mob_ab => //; [by rewrite addSn|exact: b1 hj'|exact: b2 hj|exact: (span_ab t_mono ss hj)|].
exact: (span_ab t_mono ss hj').
Qed.
(* X.close, its first line, on [t_k, t_(n+1)) *)
Theorem X_close_bound x : t k <= x < t n.+1 ->
  \sum_(1 <= i < n.+1) `|\sum_(i <= j < n.+1) (value r t m k j x - value 1 t m k j x)| <= k%:R * delta r.
Proof.
move=> hx; have [s [/andP[ks sn] hs]] := span_exists t_mono hx.
have ss : t s < t s.+1 by have /andP[a b] := hs; apply: le_lt_trans b.
have hs' : t s <= x <= t s.+1 by have /andP[-> /ltW ->] := hs.
rewrite ltnS in sn; apply: le_trans (TT_distance sn ss hs'); rewrite big_nat_cond [X in _ <= X]big_nat_cond.
apply: ler_sum => i /andP[/andP[_ hi] _]; rewrite sumrB !(@sum_TT R t t_mono n k _ s) //; try (move: sn hi; clear; lia).
Qed.
(* so the curve is at most k delta times the largest |d_i - d_(i-1)| away from the classical one *)
Theorem X_close_curve d M x : t k <= x < t n.+1 -> (forall i, (1 <= i <= n)%N -> `|d i - d i.-1| <= M) ->
  `|coordinate r t n k d x - coordinate 1 t n k d x| <= k%:R * delta r * M.
Proof.
move=> hx hM; have [s [/andP[ks sn] hs]] := span_exists t_mono hx.
have ss : t s < t s.+1 by have /andP[a b] := hs; apply: le_lt_trans b.
have hs' : t s <= x <= t s.+1 by have /andP[-> /ltW ->] := hs.
rewrite ltnS in sn; rewrite !(@C_abel R t t_mono n k _ d s) ?ks ?sn //.
have -> : forall a b e : R, a + b - (a + e) = b - e by move=> a b e; ring.
rewrite -sumrB; apply: le_trans (ler_norm_sum _ _ _) _.
have M0 : (0 < n)%N -> 0 <= M by move=> n0; apply: le_trans (hM 1%N _); rewrite ?normr_ge0.
case: (posnP n) => [n0|/M0 {}M0].
  by move: hM; rewrite n0 big_geq // => _; rewrite (_ : k = 0%N) ?mul0r //; move: ks sn; rewrite n0; clear; lia.
apply: (@le_trans _ _ (\sum_(1 <= i < n.+1) M * `|TT t s r k i x - TT t s 1 k i x|)).
  rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => i /andP[hi _].
  by rewrite -mulrBr normrM ler_wpmul2r ?normr_ge0 // hM //; move: hi; clear; lia.
by rewrite -mulr_sumr mulrC ler_wpmul2r // TT_distance.
Qed.
(* X.close: the first line on all of [t_k, t_(n+1)]; and without interior knots it is an equality at some x *)
Theorem X_close_printed : (1 <= k)%N -> t k < t n.+1 ->
  (forall x, t k <= x <= t n.+1 ->
     \sum_(1 <= i < n.+1) `|\sum_(i <= j < n.+1) (value r t m k j x - value 1 t m k j x)| <= k%:R * delta r) /\
  (n = k -> t 0%N = t k -> t k.+1 = t m -> exists x, t 0%N < x < t m /\
     \sum_(1 <= i < n.+1) `|\sum_(i <= j < n.+1) (value r t m k j x - value 1 t m k j x)| = k%:R * delta r).
Proof.
move=> k1 kn1; have D0 : 0 <= k%:R * delta r by rewrite mulr_ge0 ?ler0n ?delta_ge0.
have U : t 0%N < t m by rewrite (le_lt_trans (tle (leq0n k))) // (lt_le_trans kn1) // tle // addnS ltnS leq_addr.
split=> [x /andP[x0]|en e0 e1].
  rewrite le_eqVlt => /orP[/eqP ex|x1]; last by apply: X_close_bound; rewrite x0.
  have zero : (forall j, (j <= n)%N -> value r t m k j x = value 1 t m k j x) ->
      \sum_(1 <= i < n.+1) `|\sum_(i <= j < n.+1) (value r t m k j x - value 1 t m k j x)| <= k%:R * delta r.
    move=> h; rewrite big1 // => i _; rewrite big_nat_cond big1 ?normr0 // => j /andP[/andP[_ hj] _].
    by rewrite h ?subrr.
  case: (eqVneq x (t m)) => xm.
    by apply: zero => j hj; rewrite xm !value_tmE ?im_deg ?ltr01.
  have hx : t 0%N < x < t m.
    apply/andP; split; first by rewrite ex (le_lt_trans (tle (leq0n k))).
    by rewrite lt_neqAle xm ex tle // addnS ltnS leq_addr.
  have [p [p1 p2 p3 p4]] := mult_span_eq t_mono hx; set q := mult t m x in p2 p3 p4 *.
  have pn : (p <= n)%N by rewrite -ltnS; apply: (t_lt_ltn t_mono); rewrite -ex.
  have q0 : (0 < q)%N.
    by case: (posnP q) => // e; move: p3; rewrite e addn0 ex => /(t_lt_ltn t_mono); rewrite ltnS ltnNge pn.
  have lq : t (p + q)%N = x by apply: p2; move: q0; clear; lia.
  have fq : t p.+1 = x by apply: p2; move: q0; clear; lia.
  have V z j : value z t m k j x = P z t (p + q) k j x.
    by rewrite value_in ?(G_P z t_mono _ _ (s := (p + q)%N)) ?lq ?lexx //; case/andP: hx.
  case: (leqP q k) => qk; last first.
    apply: zero => j _; rewrite !V /P /piece; apply: N_ext => e l hl he.
    have tl : t l = x by apply: p2; move: hl he qk; clear; lia.
    by rewrite /mw tl !mob_a.
  have E z j : 0 < z -> value z t m k j x = P z t p k j x.
    move=> z0; rewrite V; apply/esym.
    exact: (@P3_1_2 R (mw z t) t t_mono (@mw_left R z t) (mw_right z0 (t := t)) p q k j x p1 p2 p3 qk).
  have hx' : t p <= x <= t p.+1 by rewrite fq lexx ltW.
  have pp : t p < t p.+1 by rewrite fq.
  apply: le_trans (TT_distance pn pp hx'); rewrite big_nat_cond [X in _ <= X]big_nat_cond.
  apply: ler_sum => i /andP[/andP[_ hi] _].
  have S z : 0 < z -> \sum_(i <= j < n.+1) value z t m k j x = TT t p z k i x.
    move=> z0; rewrite /TT -(@T_sum R _ p k i n.+1); [|by rewrite ltnS|exact: ltnW].
    by apply: eq_bigr => j _; exact: E.
  by rewrite sumrB (S r r0) (S 1 ltr01).
rewrite en in e1 U *; set a := t 0%N in U *; set b := t (k + k.+1)%N in U *.
have q0 : 0 < Num.sqrt r by rewrite sqrtr_gt0.
have s0 := sqrt1_gt0 r; have q2 : Num.sqrt r ^+ 2 = r by rewrite sqr_sqrtr // ltW.
pose x := (a * Num.sqrt r + b) / (Num.sqrt r + 1).
have xa : x - a = (b - a) / (Num.sqrt r + 1) by rewrite /x; field; rewrite gt_eqF.
have xb : b - x = (b - a) * Num.sqrt r / (Num.sqrt r + 1) by rewrite /x; field; rewrite gt_eqF.
have ba : 0 < b - a by rewrite subr_gt0.
have ax : a < x by rewrite -subr_gt0 xa divr_gt0.
have xb' : x < b by rewrite -subr_gt0 xb divr_gt0 // mulr_gt0.
exists x; split; first by rewrite ax.
have tk : t k = a by rewrite -e0.
have ss : t k < t k.+1 by rewrite tk e1.
have hx : t k <= x < t k.+1 by rewrite tk e1 ltW.
have hx' : t k < x < t k.+1 by rewrite tk e1 ax.
have tl l : (l <= k)%N -> t l = a by move=> h; apply/eqP; rewrite eq_le -{1}tk !tle.
have tr l : (k < l <= k + k.+1)%N -> t l = b.
  by move=> /andP[h1 h2]; apply/eqP; rewrite eq_le {2}/b -[t (k + k.+1)%N]e1 !tle.
have W z e j : (j <= k < j + e)%N -> (e <= k)%N -> mw z t e j x = mob z x a b.
  by move=> hj he; rewrite /mw tl ?tr //; move: hj he; clear; lia.
have S z i : (i <= k.+1)%N -> \sum_(i <= j < k.+1) value z t (k + k.+1) k j x = TT t k z k i x.
  by move=> hi; apply: (sum_TT t_mono) => //; clear; lia.
have Sum z : \sum_(1 <= i < k.+1) TT t k z k i x = k%:R * mob z x a b.
  have := @T_sum_const R (fun e j => mw z t e j x) (mob z x a b) k k (W z) (leqnn k).
  rewrite big_ltn // T_low ?add0n // -/(TT t k z k 0 x) => h.
  apply: (addrI 1); rewrite h -[k.+1]addn1 natrD; move: (k%:R) (mob z x a b) => u v; ring.
have D : mob r x a b - mob 1 x a b = (Num.sqrt r - 1) / (Num.sqrt r + 1).
  rewrite /mob xa xb; have nb : b - a != 0 by rewrite gt_eqF.
  move: (b - a) nb (Num.sqrt r) q0 s0 q2 => c nc q q0' s0' <-.
  have n1 : q + 1 != 0 by rewrite gt_eqF. have n2 : q != 0 by rewrite gt_eqF.
  have n3 : 1 + q != 0 by rewrite addrC.
  have -> : q ^+ 2 * (c / (q + 1)) / (q ^+ 2 * (c / (q + 1)) + c * q / (q + 1)) = q / (q + 1).
    have e : q ^+ 2 * (c / (q + 1)) + c * q / (q + 1) = c * q by field.
    by rewrite e; field; rewrite n1 n2 nc.
  have -> : 1 * (c / (q + 1)) / (1 * (c / (q + 1)) + c * q / (q + 1)) = 1 / (q + 1).
    have e : 1 * (c / (q + 1)) + c * q / (q + 1) = c by field.
    by rewrite e; field; rewrite n1 nc.
  by rewrite -mulrBl.
have T1 i : (i < k.+1)%N -> \sum_(i <= j < k.+1) (value r t (k + k.+1) k j x - value 1 t (k + k.+1) k j x) = TT t k r k i x - TT t k 1 k i x.
  by move=> hi; rewrite sumrB !S // ltnW.
rewrite (eq_big_nat _ _ (F2 := fun i => `|TT t k r k i x - TT t k 1 k i x|)); last by move=> i /andP[_ hi]; rewrite T1.
have Dn : delta r = `|mob r x a b - mob 1 x a b| by rewrite D normf_div (gtr0_norm s0).
have le z z' i : 0 < z -> z <= z' -> TT t k z k i x <= TT t k z' k i x.
  move=> z0; rewrite le_eqVlt => /orP[/eqP ->|zz]; first exact: lexx.
  case: (boolP (i <= k < i + k)%N) => h; first by apply/ltW/TT_r.
  case: (leqP i k) => ik; last by rewrite /TT !T_high.
  by rewrite /TT !T_low //; move: h ik; clear; lia.
have tot : \sum_(1 <= i < k.+1) (TT t k r k i x - TT t k 1 k i x) = k%:R * (mob r x a b - mob 1 x a b).
  by rewrite sumrB !Sum -mulrBr.
case: (leP 1 r) => r1.
  rewrite (eq_bigr (fun i => TT t k r k i x - TT t k 1 k i x)); last by move=> i _; rewrite ger0_norm ?subr_ge0 ?le ?ltr01.
  rewrite tot Dn; congr (_ * _); rewrite ger0_norm // D divr_ge0 ?(ltW s0) // subr_ge0.
  by rewrite -[X in X <= _]sqrtr1 ler_sqrt.
rewrite (eq_bigr (fun i => - (TT t k r k i x - TT t k 1 k i x))); last by move=> i _; rewrite ler0_norm ?subr_le0 ?le // ltW.
rewrite sumrN tot -mulrN Dn; congr (_ * _); rewrite ler0_norm // D pmulr_lle0 ?invr_gt0 // subr_le0.
by rewrite -[X in _ <= X]sqrtr1 ler_sqrt ?ltr01 ?(ltW r1).
Qed.
End Close.
