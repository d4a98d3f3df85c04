(* Conjecture 3.1 fails for every degree k >= 3 and every r <> 1. Knots 0 (k-1 times), 1, 1+e, 1+e+c: at the knot 1 the derivative of
   G_0^k from the left is negative, that from the right positive. With m = k-2, p and q the complements of the weights of [0,1+e]
   and [0,1+e+c] at 1, and H_m(p,q) the sum of all p^j q^(m-j), both are polynomials in p and q:
     D- = S/r + E,  D+ = S + E,  S = (1-p)(H_m - H_(m-1)),  E = f(p) H_m - (1-p)(f(p) dH_m/dp + f(q) dH_m/dq).
   At p = q = m/(m+1) both vanish; along a line through that point they begin with terms of opposite signs. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces Derivatives Values.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* ---- the derivatives at the knot as polynomials ---- *)
Section Algebra.
Variable R : comRingType.
Variables p q : R.
Fixpoint H (d : nat) : R := if d is d'.+1 then p ^+ d + q * H d' else 1.
Definition dpow (d : nat) : R := d%:R * p ^+ d.-1.
(* the two partial derivatives of H *)
Fixpoint K (d : nat) : R := if d is d'.+1 then dpow d + q * K d' else 0.
Fixpoint L (d : nat) : R := if d is d'.+1 then H d' + q * L d' else 0.
Lemma HS d : H d.+1 = p ^+ d.+1 + q * H d. Proof. by []. Qed.
Lemma KS d : K d.+1 = dpow d.+1 + q * K d. Proof. by []. Qed.
Lemma LS d : L d.+1 = H d + q * L d. Proof. by []. Qed.
Lemma dpowS d : dpow d.+2 = p ^+ d.+1 + p * dpow d.+1.
Proof. by rewrite /dpow /= exprS -[d.+2]addn1 natrD; ring. Qed.
Lemma H_q d : H d.+1 = q ^+ d.+1 + p * H d.
Proof.
elim: d => [|d IH]; first by rewrite /= !expr1 !mulr1 addrC.
by rewrite HS {1}IH [H d.+1]HS !exprS; ring.
Qed.
End Algebra.

Section Left.
Variable R : comRingType.
Variables (w dw : nat -> nat -> R) (s : nat) (p q u' v' z' : R).
Hypothesis hu : forall e j, (j <= s)%N -> (j + e = s.+1)%N -> w e j = 1 /\ dw e j = u'.
Hypothesis hv : forall e j, (j <= s)%N -> (j + e = s.+2)%N -> w e j = 1 - p /\ dw e j = v'.
Hypothesis hz : forall e j, (j <= s)%N -> (j + e = s.+3)%N -> w e j = 1 - q /\ dw e j = z'.
Local Notation N := (N w s). Local Notation dN := (dN w dw s).

Lemma lA d : (d <= s)%N -> N d (s - d) = (d == 0)%N%:R.
Proof.
case: d => [|d] ds; first by rewrite subn0 /= eqxx.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e2 _] := @hu d.+1 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
by rewrite NS e1 e2 subrr mul0r addr0 N_supp ?mulr0 //; move: ds; clear; lia.
Qed.
Lemma ldA d : (d < s)%N -> dN d.+1 (s - d.+1) = - u' * (d == 0)%N%:R.
Proof.
move=> ds; have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e2 e3] := @hu d.+1 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite dNS e1 e2 e3 subrr mul0r addr0 lA ?(ltnW ds) // N_supp ?dN_supp; try (move: ds; clear; lia).
by rewrite !mulr0 !add0r.
Qed.
Lemma lB d : (d <= s)%N -> N d.+1 (s - d) = p ^+ d.
Proof.
elim: d => [|d IH] ds.
  have [e2 _] := @hu 1 s (leqnn _) (addn1 _).
  by rewrite subn0 NS e2 /= eqxx; have -> : (s.+1 == s) = false by [apply/eqP; clear; lia]; rewrite mulr0 mulr1 addr0.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e2 _] := @hu d.+2 (s - d.+1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
have [e3 _] := @hv d.+2 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite NS e1 e2 e3 lA // mulr0 add0r IH ?(ltnW ds) // exprS; congr (_ * _); ring.
Qed.
Lemma ldB0 : dN 1 s = u'.
Proof.
have [e2 e3] := @hu 1 s (leqnn _) (addn1 _).
by rewrite dNS /= e3 eqxx; have -> : (s.+1 == s) = false by [apply/eqP; clear; lia]; rewrite !mulr0 mulr1 !addr0.
Qed.
Lemma ldB d : (d < s)%N -> dN d.+2 (s - d.+1) = u' * (p ^+ d.+1 - p ^+ d) - v' * dpow p d.+1.
Proof.
elim: d => [|d IH] ds.
  have e1 : ((s - 1).+1 = s)%N by move: ds; clear; lia.
  have [e2 e3] := @hu 2 (s - 1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
  have [e4 e5] := @hv 2 s ltac:(clear; lia) ltac:(clear; lia).
  have b := lB (leq0n s); rewrite subn0 in b.
  rewrite dNS e1 e2 e3 e4 e5 lA // ldA // ldB0 b /dpow /=; rewrite ?mulr0n ?mulr1n; ring.
have e1 : ((s - d.+2).+1 = s - d.+1)%N by move: ds; clear; lia.
have [e2 e3] := @hu d.+3 (s - d.+2)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
have [e4 e5] := @hv d.+3 (s - d.+1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite dNS e1 e2 e3 e4 e5 lA // ldA // IH ?(ltnW ds) // lB ?(ltnW ds) // dpowS !exprS /= mulr0n; ring.
Qed.
Lemma lC d : (d <= s)%N -> N d.+2 (s - d) = (1 - p) * H p q d.
Proof.
elim: d => [|d IH] ds.
  have [e2 _] := @hv 2 s (leqnn _) (addn2 _).
  have b := lB (leq0n s); rewrite subn0 in b.
  by rewrite subn0 NS e2 b [N 1 s.+1]N_supp ?mulr0 ?addr0 //; clear; lia.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e2 _] := @hv d.+3 (s - d.+1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
have [e3 _] := @hz d.+3 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite NS e1 e2 e3 lB // IH ?(ltnW ds) // HS; ring.
Qed.
Definition EE d : R := v' * H p q d + (1 - p) * (- v' * K p q d - z' * L p q d).
Lemma ldC0 : dN 2 s = v' + (1 - p) * u'.
Proof.
have [e2 e3] := @hv 2 s (leqnn _) (addn2 _); have b := lB (leq0n s); rewrite subn0 in b.
rewrite dNS e2 e3 b ldB0 N_supp ?dN_supp; [ring|clear; lia|clear; lia].
Qed.
(* the derivative from the left, k = d+3 *)
Theorem left_derivative d : (d < s)%N -> dN d.+3 (s - d.+1) = u' * ((1 - p) * (H p q d.+1 - H p q d)) + EE d.+1.
Proof.
rewrite /EE; elim: d => [|d IH] ds.
  have e1 : ((s - 1).+1 = s)%N by move: ds; clear; lia.
  have [e2 e3] := @hv 3 (s - 1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
  have [e4 e5] := @hz 3 s ltac:(clear; lia) ltac:(clear; lia).
  have c := lC (leq0n s); rewrite subn0 in c.
  by rewrite dNS e1 e2 e3 e4 e5 lB // ldB // c ldC0 /= /dpow /= !mulr1n; ring.
have e1 : ((s - d.+2).+1 = s - d.+1)%N by move: ds; clear; lia.
have [e2 e3] := @hv d.+4 (s - d.+2)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
have [e4 e5] := @hz d.+4 (s - d.+1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite dNS e1 e2 e3 e4 e5 lB // ldB // lC ?(ltnW ds) // IH ?(ltnW ds) //.
rewrite (HS _ _ d.+1) (KS _ _ d.+1) (LS _ _ d.+1) !(HS _ _ d) !exprS.
move: (K p q d.+1) (L p q d.+1) (H p q d) (dpow p d.+2) (p ^+ d) => k l h a b; ring.
Qed.
End Left.

Section Right.
Variable R : comRingType.
Variables (w dw : nat -> nat -> R) (s : nat) (p q y' v' z' : R).
Hypothesis hy : forall e, (0 < e)%N -> w e s.+1 = 0.
Hypothesis hy1 : dw 1%N s.+1 = y'.
Hypothesis hv : forall e j, (j <= s)%N -> (j + e = s.+2)%N -> w e j = 1 - p /\ dw e j = v'.
Hypothesis hz : forall e j, (j <= s)%N -> (j + e = s.+3)%N -> w e j = 1 - q /\ dw e j = z'.
Local Notation N := (N w s.+1). Local Notation dN := (dN w dw s.+1).
Lemma rB d : (d <= s)%N -> N d.+1 (s - d) = p ^+ d.
Proof.
elim: d => [|d IH] ds.
  rewrite subn0 NS hy // /= eqxx; have -> : (s == s.+1) = false by apply/eqP; clear; lia.
  by rewrite mulr0 add0r subr0 mul1r.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e3 _] := @hv d.+2 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite NS e1 e3 [N d.+1 (s - d.+1)]N_supp; last by move: ds; clear; lia.
rewrite mulr0 add0r IH ?(ltnW ds) // exprS; congr (_ * _); ring.
Qed.
Lemma rdB d : (d <= s)%N -> dN d.+1 (s - d) = - y' * p ^+ d - v' * dpow p d.
Proof.
elim: d => [|d IH] ds.
  rewrite subn0 dNS hy1 /= eqxx; have -> : (s == s.+1) = false by apply/eqP; clear; lia.
  by rewrite /dpow /= !mulr1n !mulr0n; ring.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e3 e4] := @hv d.+2 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite dNS e1 e3 e4 [N d.+1 (s - d.+1)]N_supp; last by move: ds; clear; lia.
rewrite [dN d.+1 (s - d.+1)]dN_supp; last by move: ds; clear; lia.
rewrite rB ?(ltnW ds) // IH ?(ltnW ds) // !mulr0 !add0r.
case: d {IH ds e1 e3 e4} => [|d]; first by rewrite /dpow /= mulr0n mulr1n; ring.
by rewrite dpowS !exprS; ring.
Qed.
Lemma r1 : N 1 s.+1 = 0 /\ dN 1 s.+1 = y'.
Proof.
rewrite NS dNS hy // hy1 /= eqxx; have -> : (s.+2 == s.+1) = false by apply/eqP; clear; lia.
by rewrite !mulr0 !mul0r !addr0 mulr1.
Qed.
Lemma rC d : (d <= s)%N -> N d.+2 (s - d) = (1 - p) * H p q d.
Proof.
elim: d => [|d IH] ds.
  have [e2 _] := @hv 2 s (leqnn _) (addn2 _).
  have b := rB (leq0n s); rewrite subn0 in b.
  by rewrite subn0 NS e2 b (proj1 r1) mulr0 addr0.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e2 _] := @hv d.+3 (s - d.+1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
have [e3 _] := @hz d.+3 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite NS e1 e2 e3 rB // IH ?(ltnW ds) // HS; ring.
Qed.
(* the derivative from the right, k = d+2 *)
Theorem right_derivative d : (d <= s)%N -> dN d.+2 (s - d) = y' * (q ^+ d - (1 - p) * H p q d) + EE p q v' z' d.
Proof.
rewrite /EE; elim: d => [|d IH] ds.
  have [e2 e3] := @hv 2 s (leqnn _) (addn2 _); have b := rB (leq0n s); rewrite subn0 in b.
  have db := rdB (leq0n s); rewrite subn0 in db.
  by rewrite subn0 dNS e2 e3 b db (proj1 r1) (proj2 r1) hy // /dpow /= !mulr0n; ring.
have e1 : ((s - d.+1).+1 = s - d)%N by move: ds; clear; lia.
have [e2 e3] := @hv d.+3 (s - d.+1)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
have [e4 e5] := @hz d.+3 (s - d)%N ltac:(clear; lia) ltac:(move: ds; clear; lia).
rewrite dNS e1 e2 e3 e4 e5 rB // rdB // rC ?(ltnW ds) // IH ?(ltnW ds) // HS KS LS !exprS.
move: (K p q d) (L p q d) (H p q d) (dpow p d.+1) (p ^+ d) (q ^+ d) => k l h a b c; ring.
Qed.
End Right.

(* ---- their expansions along a line through p = q = p0 ---- *)
Section Expansions.
Variable R : realFieldType.
Lemma taylor_eq (f : R -> R) x v l v' l' : taylor f x v l -> v = v' -> l = l' -> taylor f x v' l'.
Proof. by move=> h e1 e2; rewrite -e1 -e2. Qed.
Lemma taylor_line (c a : R) : taylor (fun h => c + a * h) 0 c a.
Proof. by exists (fun _ => 0), 1; split; [exact: bnd_const|exact: ltr01|move=> h _; ring]. Qed.
Lemma taylor_scale (f : R -> R) x v l c : taylor f x v l -> taylor (fun y => c * f y) x (c * v) (c * l).
Proof. by move=> h; apply: taylor_eq (taylor_mul (taylor_const c x) h) _ _; [|rewrite mul0r add0r]. Qed.
(* a function that begins with a positive term is positive soon *)
Lemma taylor_pos (f : R -> R) v l : taylor f 0 v l -> 0 < v \/ v = 0 /\ 0 < l ->
  exists2 d, 0 < d & forall h, 0 < h < d -> 0 < f h.
Proof.
move=> [g [d [[C [d1 [C0 d10 gC]]] d0 hf]]] [v0|[vz l0]].
  have c0 : 0 < `|l| + C + 1 by rewrite ltr_paddl ?ltr01 // addr_ge0.
  exists (Num.min (Num.min 1 (v / (`|l| + C + 1))) (Num.min d d1)); first by rewrite !lt_minr ltr01 divr_gt0 // d0.
  move=> h /andP[h0]; rewrite !lt_minr => /andP[/andP[h1 h2] /andP[h3 h4]].
  have hn : `|h| = h by rewrite gtr0_norm.
  have b : `|l * h + h ^+ 2 * g h| < v.
    have -> : l * h + h ^+ 2 * g h = h * (l + h * g h) by ring.
    rewrite normrM hn; apply: (@le_lt_trans _ _ (h * (`|l| + C))).
      rewrite ler_pmul2l // (le_trans (ler_norm_add _ _)) // ler_add2l normrM hn -[X in _ <= X]mul1r.
      by rewrite ler_pmul ?(ltW h0) ?(ltW h1) // gC // hn.
    apply: (@lt_trans _ _ (h * (`|l| + C + 1))); first by rewrite ltr_pmul2l // ltr_addl ltr01.
    by rewrite -ltr_pdivl_mulr.
  rewrite -[h]add0r hf ?hn // -addrA.
  by move: b; rewrite ltr_norml => /andP[b _]; rewrite -(ltr_add2r v) addNr [_ + v]addrC in b.
exists (Num.min (l / (C + 1)) (Num.min d d1)); first by rewrite !lt_minr d0 d10 divr_gt0 // ltr_paddl ?ltr01.
move=> h /andP[h0]; rewrite !lt_minr => /and3P[h2 h3 h4].
have hn : `|h| = h by rewrite gtr0_norm.
rewrite -[h]add0r hf ?hn // vz.
have -> : 0 + l * h + h ^+ 2 * g h = h * (l + h * g h) by ring.
apply: mulr_gt0 => //; have b : `|h * g h| < l.
  rewrite normrM hn; apply: (@le_lt_trans _ _ (h * C)); first by rewrite ler_pmul2l // gC // hn.
  apply: (@lt_trans _ _ (h * (C + 1))); first by rewrite ltr_pmul2l // ltr_addl ltr01.
  by rewrite -ltr_pdivl_mulr // ltr_paddl ?ltr01.
by move: b; rewrite ltr_norml => /andP[b _]; rewrite -(ltr_add2r l) addNr [_ + l]addrC in b.
Qed.

Variables (P Q : R -> R) (p0 a b : R).
Hypothesis p00 : p0 != 0.
Hypothesis tP : taylor P 0 p0 a.
Hypothesis tQ : taylor Q 0 p0 b.
Lemma tpow n : taylor (fun h => P h ^+ n) 0 (p0 ^+ n) (n%:R * p0 ^+ n / p0 * a).
Proof.
elim: n => [|n IH].
  by apply: taylor_eq (taylor_const 1 0) _ _; rewrite ?expr0 // mulr0n !mul0r.
apply: (@taylor_ext _ (fun h => P h * P h ^+ n)); first by move=> h; rewrite exprS.
apply: taylor_eq (taylor_mul tP IH) _ _; first by rewrite exprS.
by rewrite exprS -[n.+1]addn1 natrD; move: (p0 ^+ n) (n%:R : R) => X Y; field.
Qed.
Lemma tH n : taylor (fun h => H (P h) (Q h) n) 0 (n.+1%:R * p0 ^+ n) (n%:R * n.+1%:R / 2%:R * p0 ^+ n / p0 * (a + b)).
Proof.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
elim: n => [|n IH].
  by apply: taylor_eq (taylor_const 1 0) _ _; rewrite ?expr0 ?mulr1 // !mul0r.
apply: (@taylor_ext _ (fun h => P h ^+ n.+1 + Q h * H (P h) (Q h) n)); first by move=> h; rewrite HS.
apply: taylor_eq (taylor_add (tpow n.+1) (taylor_mul tQ IH)) _ _; rewrite !exprS -[n.+2]addn1 -[n.+1]addn1 !natrD;
  by move: (p0 ^+ n) (n%:R : R) => X Y; field; rewrite ?p00 ?two.
Qed.
Lemma tdpow n : taylor (fun h => dpow (P h) n.+1) 0 (n.+1%:R * p0 ^+ n) (n.+1%:R * n%:R * p0 ^+ n / p0 * a).
Proof. by apply: taylor_eq (taylor_scale n.+1%:R (tpow n)) _ _; rewrite // !mulrA. Qed.
Lemma tK n : taylor (fun h => K (P h) (Q h) n) 0 (n%:R * n.+1%:R / 2%:R * p0 ^+ n / p0)
  ((n%:R - 1) * n%:R * n.+1%:R / 6%:R * p0 ^+ n / p0 ^+ 2 * (2%:R * a + b)).
Proof.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0. have six : 6%:R != 0 :> R by rewrite pnatr_eq0.
elim: n => [|n IH].
  by apply: taylor_eq (taylor_const 0 0) _ _; rewrite ?mulr0 !mul0r.
apply: (@taylor_ext _ (fun h => dpow (P h) n.+1 + Q h * K (P h) (Q h) n)); first by move=> h; rewrite KS.
apply: taylor_eq (taylor_add (tdpow n) (taylor_mul tQ IH)) _ _; rewrite !exprS -[n.+2]addn1 -[n.+1]addn1 !natrD;
  by move: (p0 ^+ n) (n%:R : R) => X Y; field; rewrite ?p00 ?two ?six.
Qed.
Lemma tL n : taylor (fun h => L (P h) (Q h) n) 0 (n%:R * n.+1%:R / 2%:R * p0 ^+ n / p0)
  ((n%:R - 1) * n%:R * n.+1%:R / 6%:R * p0 ^+ n / p0 ^+ 2 * (a + 2%:R * b)).
Proof.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0. have six : 6%:R != 0 :> R by rewrite pnatr_eq0.
elim: n => [|n IH].
  by apply: taylor_eq (taylor_const 0 0) _ _; rewrite ?mulr0 !mul0r.
apply: (@taylor_ext _ (fun h => H (P h) (Q h) n + Q h * L (P h) (Q h) n)); first by move=> h; rewrite LS.
apply: taylor_eq (taylor_add (tH n) (taylor_mul tQ IH)) _ _; rewrite !exprS -[n.+2]addn1 -[n.+1]addn1 !natrD;
  by move: (p0 ^+ n) (n%:R : R) => X Y; field; rewrite ?p00 ?two ?six.
Qed.
Definition ff (rho p : R) := (1 - p) * (rho * (1 - p) + p).
Lemma tff rho F c : taylor F 0 p0 c -> taylor (fun h => ff rho (F h)) 0 (ff rho p0)
  ((- (rho * (1 - p0) + p0) + (1 - p0) * (1 - rho)) * c).
Proof.
move=> tF; have h1 := taylor_1sub tF.
apply: taylor_eq (taylor_mul h1 (taylor_add (taylor_scale rho h1) tF)) _ _; [by []|ring].
Qed.
Definition SS (p q : R) d := (1 - p) * (H p q d.+1 - H p q d).
Lemma tSS d : taylor (fun h => SS (P h) (Q h) d) 0 ((1 - p0) * (d.+2%:R * p0 ^+ d.+1 - d.+1%:R * p0 ^+ d))
  (- a * (d.+2%:R * p0 ^+ d.+1 - d.+1%:R * p0 ^+ d) +
   (1 - p0) * (d.+1%:R * d.+2%:R / 2%:R * p0 ^+ d.+1 / p0 * (a + b) - d%:R * d.+1%:R / 2%:R * p0 ^+ d / p0 * (a + b))).
Proof.
apply: (@taylor_ext _ (fun h => (1 - P h) * (H (P h) (Q h) d.+1 + (-1) * H (P h) (Q h) d))); first by move=> h; rewrite /SS; ring.
apply: taylor_eq (taylor_mul (taylor_1sub tP) (taylor_add (tH d.+1) (taylor_scale (-1) (tH d)))) _ _; ring.
Qed.
Definition E (rho p q : R) d := EE p q (ff rho p) (ff rho q) d.
Lemma tE rho d : exists v l, taylor (fun h => E rho (P h) (Q h) d) 0 v l /\
  v = ff rho p0 * (d.+1%:R * p0 ^+ d) - (1 - p0) * (ff rho p0 * (d%:R * d.+1%:R * p0 ^+ d / p0)) /\
  let f1 := - (rho * (1 - p0) + p0) + (1 - p0) * (1 - rho) in let k := d%:R * d.+1%:R / 2%:R * p0 ^+ d / p0 in
  let j := (d%:R - 1) * d%:R * d.+1%:R / 6%:R * p0 ^+ d / p0 ^+ 2 in
  l = f1 * a * (d.+1%:R * p0 ^+ d) + ff rho p0 * (k * (a + b)) + a * (2%:R * ff rho p0 * k)
      - (1 - p0) * (f1 * (a + b) * k + ff rho p0 * (j * (3%:R * (a + b)))).
Proof.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
have fP := tff rho tP; have fQ := tff rho tQ.
have h1 := taylor_mul fP (tH d).
have h2 := taylor_scale (-1) (taylor_add (taylor_mul fP (tK d)) (taylor_mul fQ (tL d))).
have h := taylor_add h1 (taylor_mul (taylor_1sub tP) h2).
do 2 eexists; split; last split.
- apply: (taylor_ext _ h) => y; rewrite /E /EE; ring.
- move: (ff rho p0) (p0 ^+ d) => X Y; field; rewrite ?p00 ?two //.
by move=> f1 k j; rewrite -/f1 -/k -/j; move: (ff rho p0) (p0 ^+ d) => X Y; ring.
Qed.
End Expansions.

(* at p0 = m/(m+1), m = d+1, along a = -(1-sg)/2, b = (1+sg)/2: both begin with a linear term *)
Section Point.
Variable R : realFieldType.
Variables (rho : R) (d : nat).
Hypothesis rho0 : 0 < rho.
Hypothesis rho1 : rho != 1.
Let m : R := d.+1%:R.
Let p0 : R := m / (m + 1).
Let W : R := m + 2%:R^-1 + 3%:R / 2%:R * rho.
Let sg : R := (1 - rho) * m / ((m + 1) * W).
Let a : R := - ((1 - sg) / 2%:R).
Let b : R := (1 + sg) / 2%:R.
Definition PP h : R := p0 + a * h.
Definition QQ h : R := p0 + b * h.
Let c : R := p0 ^+ d.+1 / p0 ^+ 2 / (m + 1) ^+ 2 * (m ^+ 2 * (1 - rho) ^+ 2 / (4%:R * W)).
Let m0 : 0 < m. Proof. by rewrite ltr0n. Qed.
Let m1 : 0 < m + 1. Proof. by rewrite addr_gt0 ?ltr01. Qed.
Let W0 : 0 < W. Proof. by rewrite !addr_gt0 // ?invr_gt0 ?mulr_gt0 ?invr_gt0 ?ltr0n. Qed.
Let p00 : 0 < p0. Proof. by rewrite divr_gt0. Qed.
Let c0 : 0 < c.
Proof.
have r2 : 0 < (1 - rho) ^+ 2 by rewrite exprn_even_gt0 //= subr_eq0 eq_sym.
have four : 0 < 4%:R :> R by rewrite ltr0n.
apply: mulr_gt0; first by do 2 (apply: divr_gt0; last by apply: exprn_gt0); exact: exprn_gt0.
by apply: divr_gt0; apply: mulr_gt0 => //; apply: exprn_gt0.
Qed.
Lemma tPP : taylor PP 0 p0 a. Proof. exact: taylor_line. Qed.
Lemma tQQ : taylor QQ 0 p0 b. Proof. exact: taylor_line. Qed.
(* the sum of the two expansions, S with a factor s *)
Lemma tsum s : exists v l, taylor (fun h => s * SS (PP h) (QQ h) d + E rho (PP h) (QQ h) d.+1) 0 v l /\ v = 0 /\
  l = p0 ^+ d.+1 / p0 ^+ 2 / (m + 1) ^+ 2 * (m / 2%:R) * ((rho - 1) * m + (rho + m + s) * (m + 1) * sg).
Proof.
have pn : p0 != 0 by rewrite gt_eqF.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0. have six : 6%:R != 0 :> R by rewrite pnatr_eq0.
have hS := taylor_scale s (tSS pn tPP tQQ d).
have [v [l [hE [ev el]]]] := tE pn tPP tQQ rho d.+1.
have mn : m != 0 by rewrite gt_eqF. have m1n : m + 1 != 0 by rewrite gt_eqF.
do 2 eexists; split; [exact: (taylor_add hS hE)|split].
  rewrite ev -[d.+2]addn1 natrD -/m exprS /ff /p0.
  move: ((m / (m + 1)) ^+ d) => X; field; rewrite ?m1n ?mn //.
rewrite {}el -[d.+2]addn1 natrD -/m !exprS /ff /a /b /p0.
have -> : d%:R = m - 1 by rewrite /m -[d.+1]addn1 natrD addrK.
move: sg ((m / (m + 1)) ^+ d) => y X; field; rewrite ?m1n ?mn ?two ?six //.
Qed.
Lemma both_signs : exists2 e, 0 < e & forall h, 0 < h < e ->
  [/\ 0 < PP h, PP h < QQ h, QQ h < 1, rho * SS (PP h) (QQ h) d + E rho (PP h) (QQ h) d.+1 < 0 &
      0 < SS (PP h) (QQ h) d + E rho (PP h) (QQ h) d.+1].
Proof.
have Wn : W != 0 by rewrite gt_eqF. have m1n : m + 1 != 0 by rewrite gt_eqF.
have two : 2%:R != 0 :> R by rewrite pnatr_eq0.
have [v [l [h1 [ev el]]]] := tsum 1; have [v' [l' [h2 [ev' el']]]] := tsum rho.
have L1 : l = c.
  rewrite el /c; move: (p0 ^+ d.+1 / p0 ^+ 2) => X.
  have -> : rho + m + 1 = W + (1 - rho) / 2%:R by rewrite /W; field.
  rewrite /sg; move: W Wn => w wn; field; rewrite ?wn ?m1n ?two //.
have L2 : l' = - c.
  rewrite el' /c; move: (p0 ^+ d.+1 / p0 ^+ 2) => X.
  have -> : rho + m + rho = W - (1 - rho) / 2%:R by rewrite /W; field.
  rewrite /sg; move: W Wn => w wn; field; rewrite ?wn ?m1n ?two //.
have h2' := taylor_scale (-1) h2; rewrite ev' mulr0 L2 mulN1r opprK in h2'.
rewrite ev L1 in h1.
have [e1 e10 H1] := taylor_pos h1 (or_intror (conj erefl c0)).
have [e2 e20 H2] := taylor_pos h2' (or_intror (conj erefl c0)).
have [e3 e30 H3] := taylor_pos tPP (or_introl p00).
have p01 : 0 < 1 - p0.
  have -> : 1 - p0 = (m + 1)^-1 by rewrite /p0; field.
  by rewrite invr_gt0.
have [e4 e40 H4] := taylor_pos (taylor_1sub tQQ) (or_introl p01).
exists (Num.min (Num.min e1 e2) (Num.min e3 e4)); first by rewrite !lt_minr e10 e20 e30.
move=> h /andP[h0]; rewrite !lt_minr => /andP[/andP[l1 l2] /andP[l3 l4]]; split.
- by apply: H3; rewrite h0.
- rewrite /PP /QQ ltr_add2l ltr_pmul2r // -subr_gt0.
  have -> : b - a = 1 by rewrite /a /b; field.
  exact: ltr01.
- by rewrite -subr_gt0 H4 // h0.
- by rewrite -oppr_gt0 -mulN1r H2 // h0.
by have := H1 h; rewrite h0 l1 mul1r => /(_ isT).
Qed.
End Point.

(* ---- the knots ---- *)
Section Knots.
Variable R : realFieldType.
Variable r : R.
Hypothesis r_gt0 : 0 < r.
Variable d : nat.
Variables p q : R.
Hypothesis p0 : 0 < p.
Hypothesis pq : p < q.
Hypothesis q1 : q < 1.
Local Notation s := d.+1.
(* 0 for i <= s, then 1, then the knots whose weights at 1 are 1-p and 1-q *)
Definition knot (i : nat) : R :=
  if (i <= s)%N then 0 else if (i <= s.+1)%N then 1 else if (i <= s.+2)%N then 1 + r * p / (1 - p) else 1 + r * q / (1 - q).
Let p1 : 0 < 1 - p. Proof. by rewrite subr_gt0 (lt_trans pq). Qed.
Let qq1 : 0 < 1 - q. Proof. by rewrite subr_gt0. Qed.
Let q0 : 0 < q := lt_trans p0 pq.
Lemma kn0 i : (i <= s)%N -> knot i = 0. Proof. by rewrite /knot => ->. Qed.
Lemma kn1 : knot s.+1 = 1. Proof. by rewrite /knot ltnn leqnn. Qed.
Lemma kn2 : knot s.+2 = 1 + r * p / (1 - p). Proof. by rewrite /knot !ltnn leqnn ltnNge leqnSn. Qed.
Lemma kn3 i : (s.+2 < i)%N -> knot i = 1 + r * q / (1 - q).
Proof.
move=> h; rewrite /knot; case: ifP => [|_]; first by move: h; clear; lia.
case: ifP => [|_]; first by move: h; clear; lia.
by case: ifP => //; move: h; clear; lia.
Qed.
Lemma e_lt : r * p / (1 - p) < r * q / (1 - q).
Proof.
rewrite -!mulrA ltr_pmul2l // ltr_pdivr_mulr // mulrAC ltr_pdivl_mulr //.
by rewrite !mulrBr !mulr1 [p * q]mulrC ltr_add2r.
Qed.
Lemma knot_mono i : knot i <= knot i.+1.
Proof.
have e0 : 0 <= r * p / (1 - p) by rewrite divr_ge0 ?mulr_ge0 // ltW.
case: (ltngtP i s) => h; first by rewrite !kn0 // ltnW.
  case: (ltngtP i s.+1) => h1; first by move: h h1; clear; lia.
    by case: (ltngtP i s.+2) => h2; [move: h1 h2; clear; lia|rewrite !kn3 //; apply: leqW|rewrite h2 kn2 kn3 // ler_add2l ltW // e_lt].
  by rewrite h1 kn1 kn2 ler_addl.
by rewrite h kn0 // kn1 ler01.
Qed.
Let F := ff r^-1.
Lemma weight_v c : 0 < c -> c < 1 ->
  mob r 1 0 (1 + r * c / (1 - c)) = 1 - c /\ dmob r 1 0 (1 + r * c / (1 - c)) = F c.
Proof.
move=> c0 c1; have rn : r != 0 by rewrite gt_eqF.
have cn : 1 - c != 0 by rewrite gt_eqF // subr_gt0.
have -> : r * c / (1 - c) = r / (1 - c) - r by field.
have dn : r * (1 - 0) + (1 + (r / (1 - c) - r) - 1) = r / (1 - c) by ring.
rewrite /mob /dmob /F /ff dn subr0; split; field; rewrite ?rn ?cn //.
Qed.
Let hu e j : (j <= s)%N -> (j + e = s.+1)%N -> mw r knot e j 1 = 1 /\ dmw r knot e j 1 = r^-1.
Proof. by move=> h1 h2; rewrite /mw /dmw h2 kn0 // kn1 mob_b ?ltr01 // dmob_b ?ltr01 // subr0 divr1. Qed.
Let hv e j : (j <= s)%N -> (j + e = s.+2)%N -> mw r knot e j 1 = 1 - p /\ dmw r knot e j 1 = F p.
Proof. by move=> h1 h2; rewrite /mw /dmw h2 kn0 // kn2; apply: weight_v => //; exact: lt_trans q1. Qed.
Let hz e j : (j <= s)%N -> (j + e = s.+3)%N -> mw r knot e j 1 = 1 - q /\ dmw r knot e j 1 = F q.
Proof. by move=> h1 h2; rewrite /mw /dmw h2 kn0 // kn3 //; apply: weight_v. Qed.
(* the derivatives of G_0^k at 1, k = d+3 *)
Theorem two_left : dP r knot s d.+3 0 1 = r^-1 * SS p q d + E r^-1 p q s.
Proof.
have := @left_derivative R (fun e j => mw r knot e j 1) (fun e j => dmw r knot e j 1) s p q r^-1 (F p) (F q) hu hv hz d (ltnSn d).
by rewrite subnn => h; apply: etrans h _.
Qed.
(* from the right *)
Theorem two_right : dP r knot s.+1 d.+3 0 1 = SS p q d + E r^-1 p q s.
Proof.
have rn : r != 0 by rewrite gt_eqF. have pn : p != 0 by rewrite gt_eqF. have p1n : 1 - p != 0 by rewrite gt_eqF.
have e0 : 1 < 1 + r * p / (1 - p) by rewrite ltr_addl divr_gt0 // mulr_gt0.
have hy e : (0 < e)%N -> mw r knot e s.+1 1 = 0 by rewrite /mw kn1 mob_a.
have hy1 : dmw r knot 1 s.+1 1 = (1 - p) / p.
  by rewrite /dmw addn1 kn1 kn2 dmob_a // addrAC subrr add0r; field; rewrite rn pn p1n.
have := @right_derivative R (fun e j => mw r knot e j 1) (fun e j => dmw r knot e j 1) s p q _ (F p) (F q) hy hy1 hv hz s (leqnn s).
rewrite subnn => h; apply: etrans h _; rewrite /E /F; congr (_ + _).
have -> : q ^+ s = H p q s - p * H p q d by rewrite (H_q p q d) addrK.
by rewrite /SS; move: (H p q s) (H p q d) => h h'; field.
Qed.
End Knots.

Lemma small_pos (R : realFieldType) (g : R -> R) l : bnd g -> 0 < l -> exists2 d, 0 < d & forall h, 0 < h < d -> 0 < l * h + h ^+ 2 * g h.
Proof.
move=> bg l0; have h : taylor (fun h => l * h + h ^+ 2 * g h) 0 0 l.
  by exists g, 1; split => // h _; rewrite !add0r.
exact: taylor_pos h (or_intror (conj erefl l0)).
Qed.

(* Conj3.1.strong.continuous is false for every degree k >= 3 and every r <> 1: knots t_0 <= .. <= t_(k+1) such that G_0^k is
   lower at x2 than at x1 < x2 and x3 > x2, all of them inside of its support; every multiplicity is at most k *)
Theorem Conj3_1_strong_continuous_printed_false (R : realFieldType) (r : R) k : 0 < r -> r != 1 -> (3 <= k)%N ->
  exists t : nat -> R, [/\ forall i, t i <= t i.+1, t 0%N < t k.+1, forall y, t 0%N < y < t k.+1 -> (mult t k.+1 y <= k)%N &
    exists x1 x2 x3, [/\ t 0%N < x1, x1 < x2, x2 < x3, x3 < t k.+1 &
      G (wt r t) t k 0 x2 < G (wt r t) t k 0 x1 /\ G (wt r t) t k 0 x2 < G (wt r t) t k 0 x3]].
Proof.
case: k => [|[|[|d]]] // r0 r1 _.
have rho0 : 0 < r^-1 by rewrite invr_gt0.
have rho1 : r^-1 != 1 by rewrite invr_eq1.
have [e e0 He] := both_signs d rho0 rho1.
have he : 0 < e / 2%:R < e by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
have [p0 pq q1 neg pos] := He _ he; set p := PP _ _ _ in p0 pq neg pos; set q := QQ _ _ _ in pq q1 neg pos.
have mono := knot_mono r0 d p0 pq q1; set t := knot r d p q in mono.
have t0 i : (i <= d.+1)%N -> t i = 0 by exact: kn0.
have t1 : t d.+2 = 1 by exact: kn1.
have p1 : 0 < 1 - p by rewrite subr_gt0 (lt_trans pq).
have t2 : 1 < t d.+3 by rewrite /t kn2 ltr_addl divr_gt0 // mulr_gt0.
have t3 : t d.+3 < t d.+4 by rewrite /t kn2 kn3 // ltr_add2l e_lt.
have U : t 0%N < t d.+4 by rewrite t0 // (lt_trans ltr01) // (lt_trans t2).
exists t; split => // [y hy|].
  have [pp [h1 h2 h3 h4]] := @mult_span_eq R t 0 d.+3 mono y hy.
  exact: (leq_ltn_trans (leq_addl _ _) h4).
have hy : t 0%N < 1 < t d.+4 by rewrite t0 // ltr01 (lt_trans t2).
have hk : (mult t d.+4 1 <= d.+3)%N.
  have [pp [h1 h2 h3 h4]] := @mult_span_eq R t 0 d.+3 mono 1 hy.
  exact: (leq_ltn_trans (leq_addl _ _) h4).
have [l [l' [hl hr]]] := P3_1_2_limits r0 mono 0 hy hk.
have [|_ el] := left_taylor_unique hl (@G_left _ _ r0 t mono d.+1 d.+3 0 1 _); first by rewrite t0 // t1 ltr01 lexx.
have [|_ er] := right_taylor_unique hr (@G_right _ _ r0 t mono d.+2 d.+3 0 1 _); first by rewrite t1 lexx t2.
rewrite el two_left // in hl; rewrite er two_right // in hr.
have [g [d1 [bg d10 hg]]] := hl; have [g' [d2 [bg' d20 hg']]] := hr.
have [e1 e10 H1] := small_pos bg' pos.
have [e2 e20 H2] := small_pos bg (l := - (r^-1 * SS p q d + E r^-1 p q d.+1)) ltac:(by rewrite oppr_gt0).
have near (A B C : R) : 0 < A -> 0 < B -> 0 < C -> exists h, [/\ 0 < h, h < A, h < B & h < C].
  move=> A0 B0 C0; have M0 : 0 < Num.min A (Num.min B C) by rewrite !lt_minr A0 B0.
  have : 0 < Num.min A (Num.min B C) / 2%:R < Num.min A (Num.min B C).
    by rewrite divr_gt0 ?ltr0n //= ltr_pdivr_mulr ?ltr0n // ltr_pmulr // ltr1n.
  move=> /andP[h0]; rewrite !lt_minr => /and3P[hA hB hC].
  by exists (Num.min A (Num.min B C) / 2%:R).
have [a [a0 a1 a2 a3]] := near d1 e2 1 d10 e20 ltr01.
have [b [b0 b1 b2 b3]] := near d2 e1 (t d.+4 - 1) d20 e10 ltac:(by case/andP: hy; rewrite subr_gt0).
exists (1 - a), 1, (1 + b); split.
- by rewrite t0 // subr_gt0.
- by rewrite ltr_subl_addr ltr_addl.
- by rewrite ltr_addl.
- by rewrite addrC -ltr_subr_addr.
split.
  by rewrite [X in _ < X]hg ?a0 // -addrA ltr_addl -mulNr H2 // a0.
by rewrite [X in _ < X]hg' ?(ltW b0) // -addrA ltr_addl H1 // b0.
Qed.
