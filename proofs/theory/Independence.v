(* P3.2: linear independence of G_0..G_n on [t_0,t_m), every degree, whenever t_i < t_(i+k+1) for all i <= n (no function is 0).
   Proof: orders of vanishing at the first knot of the smallest function that occurs. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Orders.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Paper.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable t : nat -> R.
Hypothesis t_mono : forall i, t i <= t i.+1.
Let tle := t_le t_mono.

(* P3.2: the same for all knots, if only t_i < t_{i+k+1} for i ≤ n *)
Theorem P3_2 k n (c : nat -> R) : (forall i, (i <= n)%N -> t i < t (i + k.+1)%N) ->
  (forall x, t 0%N <= x < t (n + k.+1)%N -> \sum_(0 <= j < n.+1) c j * G (wt r t) t k j x = 0) ->
  forall i, (i <= n)%N -> c i = 0.
Proof.
move=> hk H; elim/ltn_ind => i IH im.
have [s [/andP[is_ si] /andP[s1 s2]]] : exists s, (i <= s < i + k.+1)%N /\ t s <= t i < t s.+1.
  by apply: span_exists => //; rewrite lexx hk.
have isk : (i <= s <= i + k)%N by move: is_ si; clear; lia.
have sn : (s.+1 <= n + k.+1)%N by move: im si; clear; lia.
have jn0 j : (j < i)%N -> (j <= n)%N by move: im; clear; lia.
have jsk j : (i <= j)%N -> (j <= s)%N -> (j <= s <= j + k)%N by move: si; clear; lia.
have jo j : (i < j)%N -> (j <= s)%N -> ((k - (s - i)).+1 <= k - (s - j))%N by move: si; clear; lia.
set y := t i in s1 s2.
have ey j : (i <= j <= s)%N -> t j = y.
  by move=> /andP[j1 j2]; apply/eqP; rewrite eq_le (le_trans (tle j2) s1) tle.
have two : 0 < 2%:R :> R by rewrite ltr0n.
have [L L0 LL] : exists2 L, 0 < L & y + L = t s.+1 - L.
  by exists ((t s.+1 - y) / 2%:R); [rewrite divr_gt0 // subr_gt0|field].
pose Q := r * L + (t (s + k)%N - y).
have Q0 : 0 < Q.
  apply: ltr_paddr; last exact: mulr_gt0.
  by rewrite subr_ge0 /y; apply: tle; lia.
have r1 : 0 < r + 1 by rewrite addr_gt0 ?ltr01.
have [a [a0 a1 a2]] : exists a, [/\ 0 < a, a <= r / Q & a <= (r + 1)^-1].
  by exists (Num.min (r / Q) (r + 1)^-1); rewrite lt_minr !le_minl !lexx orbT divr_gt0 // invr_gt0.
pose b := r / L.
have b0 : 0 < b by rewrite /b divr_gt0.
pose M := (b + 1) ^+ k * \sum_(0 <= j < n.+1) `|c j|.
apply: (@small_zero _ (c i) (M / a ^+ k) (Num.min 1 L)); first by rewrite lt_minr ltr01.
move=> h; rewrite lt_minr => /andP[h0 /andP[h1 hL]].
pose x := y + h; pose w e j := mw r t e j x.
have xs : x < t s.+1 - L by rewrite -LL ltr_add2l.
have xspan : t s <= x < t s.+1.
  by rewrite (le_trans s1) ?ler_addl ?(ltW h0) //= (lt_trans xs) // ltr_subl_addr ltr_addl.
have W e j : (i <= j)%N -> (j <= s < j + e)%N -> w e j = r * h / (r * h + (t (j + e)%N - x)).
  move=> h2 h3; rewrite /w /mw /mob (ey j) ?h2 //; last by case/andP: h3.
  by have -> : x - y = h by rewrite /x; ring.
have B e j : (j <= s < j + e)%N -> L <= t (j + e)%N - x.
  move=> h3; have h4 : t s.+1 <= t (j + e)%N by apply: tle; case/andP: h3.
  by rewrite -(ler_add2r x) subrK; apply: le_trans h4; apply: ltW; move: (xs); rewrite ltr_subr_addr addrC.
have rh : 0 < r * h by rewrite mulr_gt0.
have D e j : (j <= s < j + e)%N -> 0 < r * h + (t (j + e)%N - x).
  by move=> /B h3; rewrite ltr_paddr // (le_trans (ltW L0)).
have wa e j : (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> a * h <= w e j.
  move=> h2 h3 h4; rewrite W // mulrAC ler_wpmul2r ?(ltW h0) //.
  have d := D _ _ h3; apply: (@le_trans _ _ (r / Q)); first exact: a1.
  rewrite ler_pmul2l // lef_pinv ?posrE // /Q ler_add //; first by rewrite ler_pmul2l // ltW.
  have jk : t (j + e)%N <= t (s + k)%N by apply: tle; case/andP: h3 => js _; exact: leq_add.
  by apply: ler_add => //; rewrite ler_opp2 /x ler_addl ltW.
have wb e j : (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> w e j <= b * h.
  move=> h2 h3 h4; rewrite W // /b [r / L * h]mulrAC ler_pmul2l // lef_pinv ?posrE ?D //.
  by rewrite (le_trans (B _ _ h3)) // ler_addr ltW.
have wq e j : (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> a <= 1 - w e j.
  move=> h2 h3 h4; rewrite W //; have d := D _ _ h3; have bb := B _ _ h3.
  set BB := t _ - x in d bb *; have -> : 1 - r * h / (r * h + BB) = BB / (r * h + BB) by field; rewrite gt_eqF.
  apply: (@le_trans _ _ (r + 1)^-1); first exact: a2.
  rewrite ler_pdivl_mulr // mulrC ler_pdivr_mulr // mulrDr mulr1 ler_add2r mulrC ler_pmul2r //.
  exact: le_trans (ltW hL) bb.
have wp e j : (i <= j)%N -> (j <= s < j + e)%N -> (e <= k)%N -> 0 <= w e j <= 1.
  move=> h2 h3 h4; rewrite (le_trans _ (wa _ _ h2 h3 h4)) ?mulr_ge0 ?(ltW a0) ?(ltW h0) //=.
  by rewrite -subr_ge0 (le_trans (ltW a0)) // wq.
have GN j : (i <= j)%N -> G (wt r t) t k j x = N w s k j by move=> _; rewrite (G_P r t_mono k j xspan).
pose o := (k - (s - i))%N.
have lo : a ^+ k * h ^+ o <= N w s k i.
  exact: (N_lower (ltW a0) (ltW b0) (ltW h0) wa wq wp (leqnn k) (leqnn i) isk).
have x0 : t 0%N <= x < t (n + k.+1)%N.
  case/andP: xspan => p1 p2; apply/andP; split.
    exact: le_trans (tle (leq0n s)) p1.
  exact: lt_le_trans p2 (tle sn).
have E : c i * N w s k i = - \sum_(0 <= j < n.+1 | j != i) c j * G (wt r t) t k j x.
  apply/eqP; rewrite -addr_eq0 -(GN i (leqnn i)); apply/eqP; rewrite -[RHS](H x x0).
  by rewrite [in RHS](bigD1_seq i) ?mem_index_iota ?iota_uniq.
have N0 j : (i <= j)%N -> 0 <= N w s k j by move=> ij; exact: (N_ge0 (ltW a0) (ltW b0) (ltW h0) wp (leqnn k) ij).
have bh : 0 <= (b + 1) ^+ k * h ^+ o.+1.
  by apply: mulr_ge0; apply: exprn_ge0; [apply: addr_ge0; [exact: ltW|exact: ler01]|exact: ltW].
have up : `|c i| * N w s k i <= M * h ^+ o.+1.
  rewrite -{1}[N w s k i](ger0_norm (N0 i (leqnn i))) -normrM E normrN.
  apply: le_trans (ler_norm_sum _ _ _) _.
  apply: (@le_trans _ _ (\sum_(0 <= j < n.+1 | j != i) `|c j| * ((b + 1) ^+ k * h ^+ o.+1))).
    rewrite big_nat_cond [X in _ <= X]big_nat_cond; apply: ler_sum => j /andP[/andP[_ jn] ji].
    case: (ltnP j i) => lt.
      by rewrite (IH j lt (jn0 j lt)) mul0r normr0 mul0r.
    have ij : (i < j)%N by rewrite ltn_neqAle eq_sym ji.
    rewrite normrM; apply: ler_wpmul2l; first exact: normr_ge0.
    rewrite (GN j lt) (ger0_norm (N0 j lt)).
    case: (leqP j s) => js; last by rewrite N_supp // negb_and -ltnNge js.
    apply: le_trans (N_upper (ltW a0) (ltW b0) (ltW h0) wb wp (leqnn k) lt (jsk j lt js)) _.
    apply: ler_wpmul2l; first by apply: exprn_ge0; apply: addr_ge0; [exact: ltW|exact: ler01].
    by apply: ler_wiexpn2l; [exact: ltW|exact: ltW|exact: jo].
  rewrite -mulr_suml mulrA; apply: ler_wpmul2r; first by apply: exprn_ge0; exact: ltW.
  rewrite [X in X <= _]mulrC; apply: ler_wpmul2l; first by apply: exprn_ge0; apply: addr_ge0; [exact: ltW|exact: ler01].
  rewrite [X in _ <= X](bigID (fun j => j != i)) /= ler_addl; apply: sumr_ge0 => j _; exact: normr_ge0.
have ak : 0 < a ^+ k by rewrite exprn_gt0.
have ho : 0 < h ^+ o by rewrite exprn_gt0.
rewrite mulrAC ler_pdivl_mulr // -(ler_pmul2r ho) -mulrA.
apply: le_trans (le_trans _ up) _; first by apply: ler_wpmul2l; [exact: normr_ge0|exact: lo].
by rewrite exprS mulrA.
Qed.
End Paper.
