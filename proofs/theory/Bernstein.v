(* P3.3: the Bernstein case, every degree, any weight. *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring zify.
From Bsplines Require Import Definitions Weight Basis Curves Pieces.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

(* one weight on every interval that contains the span *)
Theorem N_const (R : comRingType) (c : R) s d i : (i <= s)%N ->
  N (fun _ _ => c) s d i = 'C(d, s - i)%:R * c ^+ (d - (s - i)) * (1 - c) ^+ (s - i).
Proof.
elim: d i => [|d IH] i is_.
  by rewrite /= bin0n subn_eq0 sub0n expr0 mulr1; case: (ltngtP i s) is_ => // [h|->] _;
     rewrite ?subnn ?expr0 ?mul0r ?mulr1 ?leqNgt ?h ?mul0r.
rewrite NS IH //; case: (ltnP i s) => h; last first.
  have -> : i = s by lia.
  by rewrite N_supp ?mulr0 ?addr0 ?subnn ?bin0 ?subn0 ?expr0 ?mulr1 ?mul1r ?exprS //; lia.
rewrite IH //; have -> : (s - i = (s - i.+1).+1)%N by lia.
set j := (s - i.+1)%N; rewrite binS natrD subSS; case: (leqP j.+1 d) => e; last first.
  by rewrite ['C(d, j.+1)]bin_small // exprS; ring.
by have -> : (d - j = (d - j.+1).+1)%N by [lia]; rewrite !exprS; ring.
Qed.

Section Bernstein.
Variable R : realFieldType.
Variables a b : R.
Hypothesis ab : a < b.
Variable om : R -> R -> R -> R.   (* the weight: om x a b; for the paper phi r *)
Definition bknots (k i : nat) : R := if (i <= k)%N then a else b.
Definition bw k d i x := om x (bknots k i) (bknots k (i + d)%N).
(* B_i^k on [a,b]: its own knot vector (a^{k+1}, b^{k+1}); index -1 is 0 *)
Definition B k i x : R := G (bw k) (bknots k) k i x.

Lemma bknots_mono k i : bknots k i <= bknots k i.+1.
Proof. rewrite /bknots; case: (leqP i k) => h; case: (leqP i.+1 k) => h'; rewrite ?lexx ?(ltW ab) //; lia. Qed.

Lemma B_N k i x : a <= x < b -> B k i x = N (fun _ _ => om x a b) k k i.
Proof.
move=> h; rewrite /B (@G_N _ _ (bknots_mono k) _ k); last by rewrite /bknots leqnn ltnn.
apply: N_ext => d j /andP[h1 h2] _; rewrite /bw /bknots h1.
by rewrite leqNgt h2.
Qed.

(* P3.3.2: the closed form on [a, b), each B on its own knots *)
Theorem P3_3_2 k i x : (i <= k)%N -> a <= x < b ->
  B k i x = 'C(k, i)%:R * om x a b ^+ i * (1 - om x a b) ^+ (k - i).
Proof.
move=> ik h; rewrite B_N // N_const // bin_sub //; congr (_ * _ ^+ _ * _); lia.
Qed.
Lemma B_out k i x : (k < i)%N -> a <= x < b -> B k i x = 0.
Proof. by move=> ki h; rewrite B_N // N_supp //; lia. Qed.

(* P3.3.1: the recursion on [a, b), each B on its own knots *)
Theorem P3_3_1 k i x : (0 < k)%N -> a <= x < b ->
  B k i x = om x a b * (if i is j.+1 then B k.-1 j x else 0) + (1 - om x a b) * B k.-1 i x.
Proof.
case: k => // k _ h; rewrite /=.
case: (leqP i k.+1) => ik; last first.
  case: i ik => // i ik.
  by rewrite [B k.+1 _ _]B_out // [B k i x]B_out // [B k i.+1 x]B_out ?mulr0 ?addr0 //; lia.
rewrite P3_3_2 //; case: i ik => [|i] ik.
  by rewrite mulr0 add0r P3_3_2 // !bin0 !subn0 !expr0 !mul1r exprS.
rewrite [B k i x]P3_3_2 // binS natrD subSS; case: (leqP i.+1 k) => e; last first.
  by rewrite B_out // ['C(k, i.+1)]bin_small // exprS; ring.
by rewrite P3_3_2 //; have -> : (k - i = (k - i.+1).+1)%N by [lia]; rewrite !exprS; ring.
Qed.
End Bernstein.

(* the paper's weight; and on all of [a,b] with the limit at b (the piece) *)
Theorem P3_3_2_paper (R : realFieldType) (r a b x : R) k i : 0 < r -> (i <= k)%N -> a <= x < b ->
  B a b (phi r) k i x = 'C(k, i)%:R * (r * (x - a)) ^+ i * (b - x) ^+ (k - i) / (r * (x - a) + (b - x)) ^+ k.
Proof.
move=> r0 ik h; have /andP[h1 h2] := h; have ab := le_lt_trans h1 h2.
rewrite P3_3_2 // phi_in // mob_compl ?(ltW h2) // /mob !expr_div_n.
have -> : (r * (x - a) + (b - x)) ^+ k = (r * (x - a) + (b - x)) ^+ i * (r * (x - a) + (b - x)) ^+ (k - i).
  by rewrite -exprD subnKC.
rewrite invfM !mulrA; congr (_ / _).
by rewrite -!mulrA; congr (_ * (_ * _)); rewrite mulrC.
Qed.
