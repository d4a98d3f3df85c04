(* The theorems are about what the stanzas say: each printed sentence of Stanzas.v, from the theorem that answers for its claim;
   and that everything exists that it names. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Symmetry Derivatives RationalDerivative Values.
From Bsplines Require Import StatementsWeight StatementsBasis StatementsDerivatives StatementsCurves StatementsProofs StatementsBernstein.
From Bsplines Require Import Cumulative Limits Minors CurveShape Terms.
From Bsplines Require Stanzas.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* of all that is assumed only the natural numbers, for lia *)
Ltac naturals := repeat match goal with
  | H : is_true (leq _ _) |- _ => revert H
  | H : @eq nat _ _ |- _ => revert H
  end; clear; intros.
Ltac exist := intros; subst; repeat (split || intro); naturals; lia.

Section Bridge.
Variable R : realFieldType.
Implicit Types (r x : R) (t : nat -> R).

(* ---- the weight ---- *)
Theorem stanza_phi_range_printed : Stanzas.phi_range_printed R.
Proof. by move=> r r0 a b x; apply: phi_range. Qed.
Theorem stanza_P2_1_1_printed : Stanzas.P2_1_1_printed R.
Proof. by move=> r r0 a b x; apply: P2_1_1. Qed.
Theorem stanza_P2_1_2_printed : Stanzas.P2_1_2_printed R.
Proof. by move=> r r0 a b s s0 c x; apply: P2_1_2. Qed.
(* T(x) = s x + c, s < 0, is e - c x there *)
Lemma falling r a b s c x : 0 < r -> s < 0 ->
  phi r (s * x + c) (s * b + c) (s * a + c) + phi r^-1 x a b = if a < x < b then 1 else 0.
Proof.
move=> r0 s0; have n0 : 0 < - s by rewrite oppr_gt0.
by rewrite -(P2_1_3 r0 x a b c n0) !mulNr !opprK ![c + _]addrC.
Qed.
Theorem stanza_P2_1_3_amended : Stanzas.P2_1_3_amended R.
Proof. by move=> r r0 a b s s0 c x h; have := falling a b c x r0 s0; rewrite h => <-; rewrite addrK. Qed.
Theorem stanza_P2_1_3_fails : Stanzas.P2_1_3_fails R.
Proof. by move=> r r0 a b s s0 c x /negP h; rewrite falling // (negbTE h). Qed.
Theorem stanza_C2_4_amended : Stanzas.C2_4_amended R.
Proof. by move=> r r0 a b t1 t2 x h _; apply: C2_4. Qed.
Theorem stanza_C2_4_fails : Stanzas.C2_4_fails R.
Proof.
move=> r r0 a b t1 t2 x _ _ /negP h; have := P2_1_3 r0 x (a + b - t2) (a + b - t1) (a + b) ltr01.
by rewrite (negbTE h) !mul1r; have E u : a + b - (a + b - u) = u by [ring]; rewrite !E.
Qed.
Theorem stanza_R2_2_1_printed : Stanzas.R2_2_1_printed R.
Proof. by move=> r r0 a b x hx r1 ab; apply: R2_2_1_printed => //; have [] := D2_3_inv r0 r1. Qed.
Theorem stanza_R2_2_1_printed_defined : Stanzas.R2_2_1_printed_defined R.
Proof. by move=> r r0 a b x hx r1 ab; rewrite subr_eq0. Qed.
Theorem stanza_R2_2_2b_printed : Stanzas.R2_2_2b_printed R.
Proof. by move=> r r0 a b x hx ab; apply: R2_2_2b_printed. Qed.
Theorem stanza_R2_2_2b_printed_defined : Stanzas.R2_2_2b_printed_defined R.
Proof. by move=> r r0 a b x /andP[h1 h2] ab; split; [apply: mob_den_neq0|rewrite subr_eq0 gt_eqF]. Qed.
Theorem stanza_R2_2_2c_printed : Stanzas.R2_2_2c_printed R.
Proof. by move=> r r0 a b x hx ab; apply: R2_2_2c_printed. Qed.
Theorem stanza_R2_2_2c_printed_defined : Stanzas.R2_2_2c_printed_defined R.
Proof.
move=> r r0 a b x /andP[h1 h2] ab; have ri : 0 < r^-1 by rewrite invr_gt0.
have g1 : a <= a + b - x by rewrite -addrA ler_addl subr_ge0.
have g2 : a + b - x <= b by rewrite addrAC ger_addr subr_le0.
by do !split; apply: mob_den_neq0.
Qed.

(* ---- knots ---- *)
Theorem stanza_D3_1_interval_amended : Stanzas.D3_1_interval_amended R.
Proof.
move=> r r0 k k1 n m t -> [mo U] h; have le := t_le mo; split=> [H|[e0 em] i im].
  have /andP[h0 _] := H 0%N isT; have /andP[_ hm] := H _ (leqnn _).
  split; apply/eqP; rewrite eq_le; first by rewrite h0 le.
  by rewrite hm le // addnS ltnS leq_addr.
by rewrite -e0 em !le.
Qed.

(* ---- the basis ---- *)
Theorem stanza_T3_5_1_amended : Stanzas.T3_5_1_amended R.
Proof. by move=> r r0 k n m t -> [mo U] i hi x; rewrite -?addnS => /negP h1 h2 h3; apply: T3_5_1_amended. Qed.
Theorem stanza_T3_5_1_amended_defined : Stanzas.T3_5_1_amended_defined R.
Proof. exist. Qed.
Theorem stanza_T3_5_1_fails : Stanzas.T3_5_1_fails R.
Proof. by move=> r r0 k n m t -> [mo U] i hi x; rewrite -?addnS => h; apply: T3_5_1_fails. Qed.
Theorem stanza_T3_5_1_fails_defined : Stanzas.T3_5_1_fails_defined R.
Proof. exist. Qed.
Theorem stanza_T3_5_2_printed : Stanzas.T3_5_2_printed R.
Proof. by move=> r r0 k n m t -> [mo U] i hi x; rewrite -?addnS => h; apply: T3_5_2_printed. Qed.
Theorem stanza_T3_5_2_printed_defined : Stanzas.T3_5_2_printed_defined R.
Proof. exist. Qed.
Theorem stanza_T3_5_3_amended : Stanzas.T3_5_3_amended R.
Proof.
move=> r r0 k n m t -> [mo U] j j1 j2 x hx.
by have [|h1 h2] := @T3_5_3_amended R r t mo n k j x _ hx; [rewrite j1|rewrite -h1 h2].
Qed.
Theorem stanza_T3_5_3_amended_defined : Stanzas.T3_5_3_amended_defined R.
Proof. exist. Qed.
Theorem stanza_T3_5_3_fails : Stanzas.T3_5_3_fails R.
Proof.
move=> r r0 k n m t -> [mo U] j jm x hx hj; apply: (@T3_5_3_fails R r r0 t mo n k j) => //.
  by rewrite addnS ltnS.
by apply/negP => /andP.
Qed.
Theorem stanza_T3_5_3_fails_defined : Stanzas.T3_5_3_fails_defined R.
Proof. exist. Qed.
Theorem stanza_T3_5_4_amended : Stanzas.T3_5_4_amended R.
Proof. by move=> r r0 k n m t -> [mo U] s i hi x hx h; apply: T3_5_4_amended. Qed.
Theorem stanza_T3_5_4_fails : Stanzas.T3_5_4_fails R.
Proof. by move=> r r0 k n m t -> [mo U] s x hx h; apply: T3_5_4_fails. Qed.

(* ---- the basis at the ends, and at its knots ---- *)
Lemma Gleft_value r t m k i : knots t m -> Gleft r t m k i (t m) = value r t m k i (t m).
Proof. by move=> h; have [mo U] := h; rewrite Gleft_tm // value_tm /limit_left (left_span_tm mo U). Qed.
Lemma open_n1 t n k : (forall i, t i <= t i.+1) -> Uopen t n k -> (1 <= k)%N -> (1 <= n)%N.
Proof. by move=> mo [_ _ h] k1; apply: leq_trans k1 (Uopen_kn mo h). Qed.

Theorem stanza_L3_6_printed : Stanzas.L3_6_printed R.
Proof. by move=> r r0 k n m t -> [mo U] o q hq; apply: L3_6_printed. Qed.
Theorem stanza_L3_6_printed_defined : Stanzas.L3_6_printed_defined R.
Proof. move=> r r0 k n m t -> [mo U] o q hq; have := open_n1 mo o (leq_trans (ltn0Sn q) hq); exist. Qed.
Theorem stanza_L3_7_printed : Stanzas.L3_7_printed R.
Proof.
move=> r r0 k n m t -> u o q hq; have [mo U] := u; rewrite !Gleft_value // !subn1.
exact: L3_7_printed.
Qed.
Theorem stanza_L3_7_printed_defined : Stanzas.L3_7_printed_defined R.
Proof. move=> r r0 k n m t -> [mo U] o q hq; have := open_n1 mo o (leq_trans (ltn0Sn q) hq); exist. Qed.
(* a piece has no pole on its closed span: all its weights are those of intervals around the span *)
Lemma rational_const u v (c : R) : rational_on u v (fun=> c).
Proof. by exists c%:P, 1%:P; split=> x _; rewrite !hornerC ?oner_neq0 // divr1. Qed.
Lemma inside_closed (u v x : R) : u < x < v -> u <= x <= v.
Proof. by case/andP=> h1 h2; rewrite !ltW. Qed.
Lemma rational_add u v f g : rational_on u v f -> rational_on u v g -> rational_on u v (fun x => f x + g x).
Proof.
move=> [P [Q [q1 h1]]] [P' [Q' [q2 h2]]]; exists (P * Q' + P' * Q), (Q * Q'); split=> x hx; rewrite !hE.
  by rewrite mulf_neq0 ?q1 ?q2.
have n1 := q1 _ (inside_closed hx); have n2 := q2 _ (inside_closed hx); rewrite h1 ?h2 //.
by move: P.[x] Q.[x] P'.[x] Q'.[x] n1 n2 => a b c d n1 n2; field; rewrite n1 n2.
Qed.
Lemma rational_mul u v f g : rational_on u v f -> rational_on u v g -> rational_on u v (fun x => f x * g x).
Proof.
move=> [P [Q [q1 h1]]] [P' [Q' [q2 h2]]]; exists (P * P'), (Q * Q'); split=> x hx; rewrite !hE.
  by rewrite mulf_neq0 ?q1 ?q2.
by rewrite h1 ?h2 // mulf_div.
Qed.
Lemma rational_mob r u v a b : 0 < r -> a <= u -> v <= b -> a < b -> rational_on u v (fun x => mob r x a b).
Proof.
move=> r0 au vb ab; exists (r%:P * ('X - a%:P)), (r%:P * ('X - a%:P) + (b%:P - 'X)); split=> x hx; rewrite !hE.
  by have /andP[h1 h2] := hx; apply: mob_den_neq0 => //; [apply: le_trans h1|apply: le_trans vb].
by [].
Qed.
Lemma rational_value r t m k i j : 0 < r -> (forall l, t l <= t l.+1) -> (j < m)%N ->
  rational_on (t j) (t j.+1) (value r t m k i).
Proof.
move=> r0 mo jm; case: (ltP (t j) (t j.+1)) => e; last first.
  exists 0, 1%:P; split=> x hx; first by rewrite hornerC oner_neq0.
  by have /andP[h1 /(lt_trans h1)] := hx; rewrite ltNge e.
pose w x d l := if (l <= j < l + d)%N then mw r t d l x else 0.
have W d l : rational_on (t j) (t j.+1) (fun x => w x d l).
  rewrite /w; case: (boolP (l <= j < l + d)%N) => [/andP[h1 h2]|_]; last exact: rational_const.
  have a1 := t_le mo h1; have b1 := t_le mo h2.
  by apply: rational_mob => //; apply: le_lt_trans a1 (lt_le_trans e b1).
have H d l : rational_on (t j) (t j.+1) (fun x => N (w x) j d l).
  elim: d l => [|d IH] l /=; first exact: rational_const.
  apply: rational_add; apply: rational_mul => //.
  have [P [Q [q h]]] := W d.+1 l.+1; exists (Q - P), Q; split=> // x hx; rewrite !hE h //.
  by have n := q _ (inside_closed hx); move: P.[x] Q.[x] n => a b n; field.
have [P [Q [q h]]] := H k i; exists P, Q; split=> // x hx; rewrite -h //.
have hs : t j <= x < t j.+1 by have /andP[/ltW -> ->] := hx.
rewrite value_in; last by have /andP[_ x2] := hx; apply: (lt_le_trans x2); apply: (t_le mo).
by rewrite (G_N mo _ _ _ hs); apply: N_ext => d l hl _; rewrite /w hl /wt phi_in //;
  have /andP[a b] := hl; have /andP[x1 x2] := hs; rewrite (le_trans (t_le mo a) x1) (lt_le_trans x2 (t_le mo b)).
Qed.
Theorem stanza_P3_1_1_printed : Stanzas.P3_1_1_printed R.
Proof. by move=> r r0 k n m t -> [mo U] i hi j hj; apply: rational_value => //; rewrite addnS ltnS. Qed.
Theorem stanza_P3_1_1_printed_defined : Stanzas.P3_1_1_printed_defined R.
Proof. exist. Qed.
Theorem stanza_P3_1_extension_printed : Stanzas.P3_1_extension_printed R.
Proof. by move=> r r0 k n m t -> [mo U] i hi; apply: (P3_1_extension r0 mo U hi). Qed.
Theorem stanza_T3_11_1_printed : Stanzas.T3_11_1_printed R.
Proof. by move=> r r0 k n m t -> [mo U] i hi j hj; apply: T3_11_1_printed => //; rewrite addnS ltnS. Qed.
Theorem stanza_T3_11_1_printed_defined : Stanzas.T3_11_1_printed_defined R.
Proof. exist. Qed.
Theorem stanza_T3_11_2_amended : Stanzas.T3_11_2_amended R.
Proof.
move=> r r0 k n m t -> u i hi j hj; have [mo U] := u; have [h1 h2 h3] := T3_11_2_amended r0 mo U hi hj.
split=> [h|]; first by eexists; eexists; apply: h1.
split=> [h|[h c]].
  by split; [eexists; eexists; apply: h2|rewrite Gright_in // h t_le].
by rewrite Gleft_in ?h ?t_le // h3.
Qed.
Theorem stanza_T3_11_2_fails : Stanzas.T3_11_2_fails R.
Proof.
move=> r r0 k n m t -> u j hj h hk; have [mo U] := u; have [i [hi ne]] := T3_11_2_fails r0 mo hj h hk.
by exists i; rewrite Gleft_in //; have /andP[-> /ltW ->] := h.
Qed.
Theorem stanza_P3_1_2_printed : Stanzas.P3_1_2_printed R.
Proof.
move=> r r0 k n m t -> u h i hi x hx hk; have [mo U] := u.
split=> [|x0]; first exact: Gright_in.
have [_ /(_ x0) [l hl]] := P3_1_2_printed r0 mo h hk hi hx.
have hx' : t 0%N < x <= t (n + k.+1)%N by rewrite x0; have /andP[_ /ltW ->] := hx.
by have [-> _] := left_taylor_unique hl (DleftP r0 mo k i hx'); rewrite Gleft_in.
Qed.
Theorem stanza_P3_1_3_amended : Stanzas.P3_1_3_amended R.
Proof.
move=> r r0 k n m t -> u c; have [mo U] := u; have [h1 h2 h3 h4] := P3_1_3_amended r0 mo U c.
split=> //; split=> [i i1 i2|]; first by rewrite h2 // i1.
by split=> [|i hi]; rewrite Gleft_value // h4.
Qed.
Theorem stanza_P3_1_3_amended_defined : Stanzas.P3_1_3_amended_defined R.
Proof. exist. Qed.
Theorem stanza_P3_1_3_fails : Stanzas.P3_1_3_fails R.
Proof. by move=> r r0 k n m t -> u o h; have [mo U] := u; rewrite Gleft_value //; apply: P3_1_3_fails. Qed.

Theorem stanza_L3_8_amended : Stanzas.L3_8_amended R.
Proof.
move=> r r0 k n m t -> u o q hq h; have [mo U] := u; rewrite !DGright_t0 //.
have [-> -> h3] := L3_8_amended r mo o hq h; do 2![split=> //] => i i1 i2.
by rewrite !DGright_t0 // h3 // i1.
Qed.
Theorem stanza_L3_8_amended_defined : Stanzas.L3_8_amended_defined R.
Proof. move=> r r0 k n m t -> [mo U] o q hq _; have := open_n1 mo o (leq_trans (ltn0Sn q) hq); exist. Qed.
Theorem stanza_L3_8_fails : Stanzas.L3_8_fails R.
Proof.
move=> r r0 k n m t -> u o q hq h; have [mo U] := u; have [i [/andP[i1 i2] ne]] := L3_8_fails r0 mo U o hq h.
by exists i; rewrite !DGright_t0.
Qed.
Theorem stanza_L3_8_fails_defined : Stanzas.L3_8_fails_defined R.
Proof. exist. Qed.
Theorem stanza_L3_9_amended : Stanzas.L3_9_amended R.
Proof.
move=> r r0 k n m t -> u o q hq h; have [mo U] := u; rewrite !DGleft_tm // subn1.
exact: L3_9_amended.
Qed.
Theorem stanza_L3_9_amended_defined : Stanzas.L3_9_amended_defined R.
Proof. move=> r r0 k n m t -> [mo U] o q hq _; have := open_n1 mo o (leq_trans (ltn0Sn q) hq); exist. Qed.
Theorem stanza_L3_9_fails : Stanzas.L3_9_fails R.
Proof.
move=> r r0 k n m t -> u o q hq h; have [mo U] := u; rewrite !DGleft_tm // subn1.
exact: L3_9_fails.
Qed.
Theorem stanza_L3_9_fails_defined : Stanzas.L3_9_fails_defined R.
Proof. move=> r r0 k n m t -> [mo U] o q hq _; have := open_n1 mo o (leq_trans (ltn0Sn q) hq); exist. Qed.
Theorem stanza_L3_10_amended : Stanzas.L3_10_amended R.
Proof. by move=> r r0 k k2 n m t -> u o i hi h; have [mo U] := u; rewrite DGleft_tm //; apply: L3_10_amended. Qed.
Theorem stanza_L3_10_amended_defined : Stanzas.L3_10_amended_defined R.
Proof. exist. Qed.
Theorem stanza_L3_10_fails : Stanzas.L3_10_fails R.
Proof.
move=> r r0 k k2 n m t -> u o h; have [mo U] := u; have [i [hi ne]] := L3_10_fails r0 mo U k2 o h.
by exists i; rewrite DGleft_tm.
Qed.
Theorem stanza_L3_10_fails_defined : Stanzas.L3_10_fails_defined R.
Proof. exist. Qed.
Theorem stanza_T3_11_3a_amended : Stanzas.T3_11_3a_amended R.
Proof.
move=> r r0 k k1 n m t -> u o h; have [mo U] := u; have [h1 h2 h3] := T3_11_3a_amended r0 mo k1 o h.
by rewrite !DGright_t0 // h1 h2 opprK; do !split=> // i i1 i2; rewrite DGright_t0 // h3 // i1.
Qed.
Theorem stanza_T3_11_3a_amended_defined : Stanzas.T3_11_3a_amended_defined R.
Proof.
move=> r r0 k k1 n m t -> [mo U] o h; split; first exact: open_n1 o k1.
by rewrite subr_eq0 gt_eqF // (le_lt_trans _ h) // t_le.
Qed.
Theorem stanza_T3_11_3a_fails : Stanzas.T3_11_3a_fails R.
Proof.
move=> r r0 k k1 n m t -> u o h; have [mo U] := u; have [i [/andP[i1 i2] ne]] := T3_11_3a_fails r0 mo U k1 o h.
by exists i; rewrite DGright_t0.
Qed.
Theorem stanza_T3_11_3b_amended : Stanzas.T3_11_3b_amended R.
Proof.
move=> r r0 k k1 n m t -> u o h; have [mo U] := u; have [h1 h2 h3] := T3_11_3b_amended r0 mo U k1 o h.
by rewrite !DGleft_tm // subn1 h1 h2 opprK; do !split=> // i hi; rewrite DGleft_tm // h3.
Qed.
Theorem stanza_T3_11_3b_amended_defined : Stanzas.T3_11_3b_amended_defined R.
Proof.
move=> r r0 k k1 n m t -> [mo U] o h; split; first exact: open_n1 o k1.
split=> [|i]; last by naturals; lia.
by rewrite mulf_neq0 ?gt_eqF // subr_gt0 (lt_le_trans h) // t_le // addnS ltnS leq_addr.
Qed.
Theorem stanza_T3_11_3b_fails : Stanzas.T3_11_3b_fails R.
Proof.
move=> r r0 k k1 n m t -> u o h; have [mo U] := u; have [i [hi ne]] := T3_11_3b_fails r0 mo U k1 o h.
by exists i; rewrite DGleft_tm.
Qed.
Theorem stanza_T3_11_3b_fails_defined : Stanzas.T3_11_3b_fails_defined R.
Proof. exist. Qed.
Theorem stanza_Rem3_1_printed : Stanzas.Rem3_1_printed R.
Proof.
move=> r r0 k k2 n m t -> u s i hi r1; have [mo U] := u.
have [j [/andP[j1 j2] ne]] := Rem3_1_printed r0 mo k2 s hi r1.
have up a b : (a < b <= n + k.+1)%N -> t a < t b.
  elim: b => // b IH /andP[]; rewrite ltnS leq_eqVlt => /orP[/eqP ->|ab] bm; first exact: s.
  by apply: lt_trans (s _ bm); apply: IH; rewrite ab ltnW.
have jm : (j < n + k.+1)%N by rewrite addnS ltnS (leq_trans j2) // leq_add2r.
have j0 : (0 < j)%N := leq_ltn_trans (leq0n i) j1.
have h0 : t 0%N < t j by apply: up; rewrite j0 ltnW.
have hm : t j < t (n + k.+1)%N by apply: up; rewrite jm /=.
by exists j; do 2![split=> //]; rewrite DGleft_in ?DGright_in // ?h0 ?hm ?(ltW h0) ?(ltW hm).
Qed.
Theorem stanza_Rem3_1_printed_defined : Stanzas.Rem3_1_printed_defined R.
Proof. exist. Qed.

(* ---- the Bernstein case ---- *)
Theorem stanza_P3_3_1_amended : Stanzas.P3_3_1_amended R.
Proof.
move=> r r0 k k1 n m t -> [mo U] [o e] i hi x hx; subst n.
by rewrite (P3_3_1_amended mo o r k1 hi hx) subn1.
Qed.
Theorem stanza_P3_3_1_amended_defined : Stanzas.P3_3_1_amended_defined R.
Proof. by move=> r r0 k k1 n m t -> [mo U] [o e] i hi x hx; rewrite e hi leqW. Qed.
Theorem stanza_P3_3_1_fails : Stanzas.P3_3_1_fails R.
Proof.
move=> r r0 k k1 n m t -> [mo U] [o e] i i1 i2 x; subst n; rewrite -eq_le => /eqP <-; rewrite subn1.
by apply: P3_3_1_fails => //; rewrite i2 andbT -ltnS prednK.
Qed.
Theorem stanza_P3_3_1_fails_defined : Stanzas.P3_3_1_fails_defined R.
Proof. by move=> r r0 k k1 n m t -> [mo U] [o e] i i1 hi x hx; rewrite e hi leqW. Qed.
Theorem stanza_P3_3_2_amended : Stanzas.P3_3_2_amended R.
Proof. by move=> r r0 k n m t -> [mo U] [o e] i hi x hx; subst n; apply: P3_3_2_amended. Qed.
Theorem stanza_P3_3_2_amended_defined : Stanzas.P3_3_2_amended_defined R.
Proof. by move=> r r0 k n m t -> [mo U] [o e] i hi x hx; rewrite e. Qed.
Theorem stanza_P3_3_2_fails : Stanzas.P3_3_2_fails R.
Proof.
move=> r r0 k k1 n m t -> [mo U] [o e] i hi x; subst n; rewrite -eq_le => /eqP <- h.
exact: P3_3_2_fails.
Qed.
Theorem stanza_P3_3_2_fails_defined : Stanzas.P3_3_2_fails_defined R.
Proof. by move=> r r0 k k1 n m t -> [mo U] [o e] i hi x hx h; rewrite e. Qed.
Theorem stanza_abstract_bezier_printed : Stanzas.abstract_bezier_printed R.
Proof.
by move=> r r0 k k1 n m t -> [mo U] [o e] s s0 x hx; subst n; rewrite (abstract_bezier mo o k1 r0 s0 hx).
Qed.
Theorem stanza_abstract_bezier_points_amended : Stanzas.abstract_bezier_points_amended R.
Proof. by move=> r r0 k n m t -> [mo U] [o e] d x hx; subst n; apply: abstract_bezier_points_amended. Qed.
Theorem stanza_abstract_bezier_points_amended_defined : Stanzas.abstract_bezier_points_amended_defined R.
Proof.
move=> r r0 k n m t -> [mo U] [o e] d x /andP[x0 xm] i hi; subst n; split=> //.
exact: mob_den_neq0.
Qed.

(* ---- curves ---- *)
Theorem stanza_P4_1_1_amended : Stanzas.P4_1_1_amended R.
Proof. by move=> r r0 k n m t -> [mo U] o d j hj x hx; rewrite -?addnS => /negP h1 h2; apply: P4_1_1_amended. Qed.
Theorem stanza_P4_1_1_amended_defined : Stanzas.P4_1_1_amended_defined R.
Proof. exist. Qed.
Theorem stanza_P4_1_1_fails : Stanzas.P4_1_1_fails R.
Proof. by move=> r r0 k n m t -> [mo U] o d j hj x hx [h1 [h2 h3]]; rewrite h3; apply: (P4_1_1_fails r0 mo U d o hj h1); rewrite h2. Qed.
Theorem stanza_P4_1_1_fails_defined : Stanzas.P4_1_1_fails_defined R.
Proof. exist. Qed.
Theorem stanza_P4_1_2_printed : Stanzas.P4_1_2_printed R.
Proof. by move=> r r0 k n m t -> [mo U] o d j j1 j2 x hx; apply: P4_1_2_printed => //; rewrite j1. Qed.
Theorem stanza_P4_1_2_printed_defined : Stanzas.P4_1_2_printed_defined R.
Proof. exist. Qed.
Theorem stanza_P4_1_3_printed : Stanzas.P4_1_3_printed R.
Proof. by move=> r r0 k n m t -> [mo U] o x hx; apply: P4_1_3_printed. Qed.
Theorem stanza_P4_1_4_printed : Stanzas.P4_1_4_printed R.
Proof. by move=> r r0 k n m t -> [mo U] o d c x hx; apply: P4_1_4_printed. Qed.
Theorem stanza_P4_2_1_amended : Stanzas.P4_2_1_amended R.
Proof. by move=> r r0 k n m t -> [mo U] o d; apply: P4_2_1_amended. Qed.
Theorem stanza_P4_2_1_fails : Stanzas.P4_2_1_fails R.
Proof.
move=> r r0 k n m t -> [mo U] o d p p1 p2; have [|h1 h2] := @P4_2_1_fails R r r0 t mo n k U d p o; first by rewrite p1.
split=> [[e l]|]; first exact: h1.
rewrite subSn // => -[l e]; exact: h2 l e.
Qed.
Theorem stanza_P4_2_1_fails_defined : Stanzas.P4_2_1_fails_defined R.
Proof. exist. Qed.
(* a sum of which the first two, or the last two, are not 0 *)
Lemma sum_first (d e : nat -> R) n : (forall i, (2 <= i <= n)%N -> e i = 0) -> (1 <= n)%N ->
  \sum_(0 <= i < n.+1) d i * e i = d 0%N * e 0%N + d 1%N * e 1%N.
Proof.
move=> z n1; rewrite big_ltn // big_ltn // big_nat_cond big1 ?addr0 // => i /andP[/andP[i1 i2] _].
by rewrite z ?mulr0 // i1.
Qed.
Lemma sum_last (d e : nat -> R) n : (forall i, (i.+2 <= n)%N -> e i = 0) -> (1 <= n)%N ->
  \sum_(0 <= i < n.+1) d i * e i = d (n - 1)%N * e (n - 1)%N + d n * e n.
Proof.
case: n => // n z _; rewrite subn1 /= big_nat_recr //= big_nat_recr //= big_nat_cond big1 ?add0r // => i /andP[/andP[_ hi] _].
by rewrite z ?mulr0.
Qed.
Theorem stanza_P4_2_2_amended : Stanzas.P4_2_2_amended R.
Proof.
move=> r r0 k k1 n m t -> u [o h1 h2] d; have [mo U] := u; have n1 := open_n1 mo o k1.
have [a1 a0 az] := T3_11_3a_amended r0 mo k1 o h1; have [bn bp bz] := T3_11_3b_amended r0 mo U k1 o h2.
split.
  rewrite sum_first // => [|i hi]; last by rewrite DGright_t0 // az.
  by rewrite !DGright_t0 // a0 a1; ring.
rewrite sum_last // => [|i hi]; last by rewrite DGleft_tm // bz.
by rewrite !DGleft_tm // subn1 bn bp; ring.
Qed.
Theorem stanza_P4_2_2_amended_defined : Stanzas.P4_2_2_amended_defined R.
Proof.
move=> r r0 k k1 n m t -> [mo U] [o h1 h2] d; have n1 := open_n1 mo o k1.
have e1 : t k.+1 - t 0%N != 0 by rewrite subr_eq0 gt_eqF // (le_lt_trans _ h1) // t_le.
have e2 : r * (t (n + k.+1)%N - t n) != 0.
  by rewrite mulf_neq0 ?gt_eqF // subr_gt0 (lt_le_trans h2) // t_le // addnS ltnS leq_addr.
by do ?split.
Qed.
Theorem stanza_P3_2_printed : Stanzas.P3_2_printed R.
Proof. by move=> r r0 k n m t -> [mo U] o h c z i hi; apply: (P3_2_printed r0 mo o h z). Qed.
Theorem stanza_P4_3_amended : Stanzas.P4_3_amended R.
Proof. by move=> r r0 k n m t -> [mo U] o s d x hx h; apply: P4_3_amended. Qed.
Theorem stanza_P4_3_fails : Stanzas.P4_3_fails R.
Proof. by move=> r r0 k n m t -> [mo U] o s x hx h; apply: P4_3_fails. Qed.

(* ---- steps of proofs ---- *)
Theorem stanza_proof_T3_5_2_cover_amended : Stanzas.proof_T3_5_2_cover_amended R.
Proof.
move=> r r0 k k1 n m t -> [mo U] i hi x hx; rewrite -?addnS => h.
by rewrite -(proof_T3_5_2_cover_amended mo x k1 h); split=> /orP.
Qed.
Theorem stanza_proof_T3_5_2_cover_amended_defined : Stanzas.proof_T3_5_2_cover_amended_defined R.
Proof. exist. Qed.
Theorem stanza_proof_T3_5_2_cover_fails : Stanzas.proof_T3_5_2_cover_fails R.
Proof.
move=> r r0 k k1 n m t -> [mo U] i hi x hx; rewrite -?addnS => -[h1 [h2 h3]].
have e := proof_T3_5_2_cover_fails x k1 h1 h2 h3.
split=> [/orP|/andP] h; first by apply/andP; rewrite -e.
by apply/orP; rewrite e.
Qed.
Theorem stanza_proof_T3_5_2_cover_fails_defined : Stanzas.proof_T3_5_2_cover_fails_defined R.
Proof. exist. Qed.
Theorem stanza_proof_P4_1_1_iff_amended : Stanzas.proof_P4_1_1_iff_amended R.
Proof.
move=> r r0 k n m t -> [mo U] j hj x; rewrite -?addnS => h1 h2.
rewrite (proof_P4_1_1_iff_amended r0 mo U hj h1); first by [].
by case=> a [b c]; apply: h2; rewrite -c.
Qed.
Theorem stanza_proof_P4_1_1_iff_amended_defined : Stanzas.proof_P4_1_1_iff_amended_defined R.
Proof. exist. Qed.
Theorem stanza_proof_P4_1_1_iff_fails : Stanzas.proof_P4_1_1_iff_fails R.
Proof.
move=> r r0 k n m t -> [mo U] j hj x; rewrite -?addnS => h.
apply: (proof_P4_1_1_iff_fails r0 mo U hj); case: h => [h|[a [b c]]]; [by left|right].
by rewrite -c.
Qed.
Theorem stanza_proof_P4_1_1_iff_fails_defined : Stanzas.proof_P4_1_1_iff_fails_defined R.
Proof. exist. Qed.
Theorem stanza_proof_T3_5_3_iff_amended : Stanzas.proof_T3_5_3_iff_amended R.
Proof.
move=> r r0 k n m t -> [mo U] j hj i hi x hx; have jm : (j < n + k.+1)%N by rewrite addnS ltnS.
rewrite (proof_T3_5_3_iff_amended r0 mo jm hi hx) leq_subLR [(k + i)%N]addnC.
split=> [/andP[/andP[-> ->]] /orP[/orP[a|b]|/eqP c]|[[-> ->] h]] /=.
- by split; [split|left].
- by split; [split|right; left].
- by split; [split|right; right].
by case: h => [->|[->|<-]]; rewrite ?eqxx ?orbT.
Qed.
Theorem stanza_proof_T3_5_3_iff_amended_defined : Stanzas.proof_T3_5_3_iff_amended_defined R.
Proof. exist. Qed.
Theorem stanza_proof_P4_1_2_iff_amended : Stanzas.proof_P4_1_2_iff_amended R.
Proof. by move=> r r0 k n m t e u o; apply: stanza_proof_T3_5_3_iff_amended e u. Qed.
Theorem stanza_proof_P4_1_2_iff_amended_defined : Stanzas.proof_P4_1_2_iff_amended_defined R.
Proof. exist. Qed.
Theorem stanza_proof_T3_5_4_base_amended : Stanzas.proof_T3_5_4_base_amended R.
Proof.
move=> r r0 k; rewrite leqn0 => /eqP -> n m t -> [mo U] s x hx i hi h.
by apply: T3_5_4_amended => //; case: h => [->|[->|->]]; [left|right; left|right; right].
Qed.
Theorem stanza_proof_T3_5_4_base_fails : Stanzas.proof_T3_5_4_base_fails R.
Proof. by move=> r r0 k; rewrite leqn0 => /eqP -> n m t -> [mo U] s x hx h; apply: T3_5_4_fails. Qed.
Theorem stanza_proof_T3_5_4_corollary_amended : Stanzas.proof_T3_5_4_corollary_amended R.
Proof.
move=> r r0 k k1 n m t -> [mo U] s i hi x hx h; rewrite !subn1 (proof_T3_5_4_corollary_amended r0 mo k1 s hi hx h).
have -> : (n + k.+1 - i - k = n.+1 - i)%N by naturals; lia.
by have -> : (n + k.+1 - k - i = n.+1 - i)%N by naturals; lia.
Qed.
Theorem stanza_proof_T3_5_4_corollary_amended_defined : Stanzas.proof_T3_5_4_corollary_amended_defined R.
Proof. exist. Qed.
Theorem stanza_proof_P4_3_bisector_amended : Stanzas.proof_P4_3_bisector_amended R.
Proof.
move=> r r0 k n m t -> [mo U] o s h d; have [h1 h2] := proof_P4_3_bisector_amended r0 mo U d o s h.
by split=> [x|c z i]; [apply: h1|apply: (h2 c z)].
Qed.

(* ---- our questions ---- *)
Theorem stanza_X_monotone_printed : Stanzas.X_monotone_printed R.
Proof.
move=> r r0 k k1 n m t -> [mo U] l l1 l2 j j1 j2 x hx.
by apply: (X_monotone_printed r0 mo _ _ hx); rewrite ?l1 //; naturals; lia.
Qed.
Theorem stanza_X_monotone_printed_defined : Stanzas.X_monotone_printed_defined R.
Proof. exist. Qed.
Theorem stanza_X_minors_printed : Stanzas.X_minors_printed R.
Proof.
by move=> r r0 k k1 n m t -> [mo U] l lm i i_n x hx; apply: (X_minors_printed r0 mo _ i_n hx); rewrite addnS ltnS.
Qed.
Theorem stanza_X_minors_printed_defined : Stanzas.X_minors_printed_defined R.
Proof. exist. Qed.
Theorem stanza_X_order_printed : Stanzas.X_order_printed R.
Proof.
move=> r r0 k k1 n m t -> [mo U] s s0 l l1 l2 j j1 j2 x hx.
apply: (X_order_printed mo k1 r0 _ _ _ hx); rewrite ?ltr_addl ?l1 //.
by rewrite leq_subLR addnC j1.
Qed.
Theorem stanza_X_order_printed_defined : Stanzas.X_order_printed_defined R.
Proof. exist. Qed.
Theorem stanza_X_limit_printed : Stanzas.X_limit_printed R.
Proof.
move=> r r0 k k1 n m t -> [mo U] j j1 j2 x hx; have hj : (k <= j <= n)%N by rewrite j1.
by rewrite subSn // div1r; apply: (X_limit_printed r0 mo k1 hj hx).
Qed.
Theorem stanza_X_limit_printed_defined : Stanzas.X_limit_printed_defined R.
Proof.
move=> r r0 k k1 n m t -> [mo U] j j1 j2; have b i : (i <= j + k)%N -> (i <= n + k.+1)%N by naturals; lia.
split; first by naturals; lia. split; first by naturals; lia.
move=> x /andP[x1 x2]; split; first by naturals; lia.
split=> [i i1 i2|].
  by split; [rewrite b // (leq_trans i2) // leq_addr|rewrite gt_eqF // subr_gt0].
split=> [|i i1 i2]; first by rewrite gt_eqF.
by split; [rewrite b|rewrite gt_eqF // subr_gt0].
Qed.
End Bridge.
