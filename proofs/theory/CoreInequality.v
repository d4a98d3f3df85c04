(* Core theorem (theory.md, Lemmas 5, 6, 8 and Theorem A) over any ordered field, from the tower relation (2).
   I: occurrences of weighted knots, y l: signed distance at x, D 0 = C, D 1 = D, D 2 = D', D 3 = D'', ... *)
From mathcomp Require Import all_ssreflect all_algebra.
From mathcomp Require Import ring.
Import Order.TTheory GRing.Theory Num.Theory.
Set Implicit Arguments. Unset Strict Implicit. Unset Printing Implicit Defensive.
Local Open Scope ring_scope.

Section Core.
Variable R : realFieldType.
Variable I : eqType.
Variable y : I -> R.
Definition lft l := y l < 0.
Definition rgt l := 0 < y l.
Hypothesis y_side : forall l, lft l || rgt l.
Variable D : nat -> seq I -> R.
Hypothesis Dperm : forall j s t, perm_eq s t -> D j s = D j t.
Hypothesis tower : forall j s l, (j < size s)%N -> D j s = D j (l :: s) + y l * D j.+1 (l :: s).
Definition two s := has lft s && has rgt s.
Hypothesis Dpos : forall s, two s -> 0 < D 1 s.
Hypothesis Done : forall s, (2 <= size s)%N -> ~~ two s -> D 1 s = 0.

Lemma y_neq0 l : y l != 0.
Proof. by case/orP: (y_side l) => h; [rewrite lt_eqF | rewrite gt_eqF]. Qed.
Lemma lft_rgtF l : lft l -> rgt l = false.
Proof. by rewrite /lft /rgt => h; apply: negbTE; rewrite -leNgt ltW. Qed.
Lemma rgt_lftF l : rgt l -> lft l = false.
Proof. by rewrite /lft /rgt => h; apply: negbTE; rewrite -leNgt ltW. Qed.

Lemma two_perm s t : perm_eq s t -> two s = two t.
Proof. by move=> p; rewrite /two !(perm_has _ p). Qed.
Lemma two_cons l s : two s -> two (l :: s).
Proof. by case/andP=> h1 h2; rewrite /two /= h1 h2 !orbT. Qed.
Lemma two_one_pos s : two s || ~~ two s. Proof. exact: orbN. Qed.
Lemma Dge0 s : (2 <= size s)%N -> 0 <= D 1 s.
Proof. by move=> z; case: (boolP (two s)) => [/Dpos/ltW|/(Done z) ->]. Qed.

Definition ell s := D 2 s / D 1 s.
Lemma ell_perm s t : perm_eq s t -> ell s = ell t.
Proof. by move=> p; rewrite /ell !(Dperm _ p). Qed.

(* D_V = D_(V+l) (1 + y_l ell_(V+l)) *)
Lemma step l s : (2 <= size s)%N -> two (l :: s) -> D 1 s = D 1 (l :: s) * (1 + y l * ell (l :: s)).
Proof.
move=> z t; rewrite (tower l) // /ell; have := Dpos t => h; have h' : D 1 (l :: s) != 0 by rewrite gt_eqF.
by field.
Qed.

(* (i) *)
Lemma between V l r : (2 <= size V)%N -> two V -> lft l -> rgt r ->
  ell (l :: V) <= ell (r :: V) ->
  ell (l :: V) <= ell (l :: r :: V) <= ell (r :: V).
Proof.
move=> zV tV hl hr xz.
set x := ell (l :: V) in xz *; set z := ell (r :: V) in xz *; set u := ell (l :: r :: V).
pose a := - y l; pose b := y r.
have a0 : 0 < a by rewrite oppr_gt0.
have tl := two_cons l tV; have tr := two_cons r tV; have tlr := two_cons l tr.
have e1 : D 1 V = D 1 (r :: V) * (1 + b * z) by apply: step.
have e2 : D 1 V = D 1 (l :: V) * (1 - a * x) by rewrite /a mulNr opprK; apply: step.
have e3 : D 1 (r :: V) = D 1 (l :: r :: V) * (1 - a * u).
  by rewrite /a mulNr opprK; apply: step => //; apply: ltnW.
have pm : perm_eq (l :: r :: V) (r :: l :: V) by rewrite (perm_catCA [:: l] [:: r]).
have e4 : D 1 (l :: V) = D 1 (l :: r :: V) * (1 + b * u).
  rewrite (Dperm 1 pm) /u (ell_perm pm); apply: step; first exact: ltnW.
  by rewrite -(two_perm pm).
have d0 := Dpos tV; have dl := Dpos tl; have dr := Dpos tr; have dlr := Dpos tlr.
have P0 : 0 < 1 + b * z by rewrite -(pmulr_rgt0 _ dr) -e1.
have Q0 : 0 < 1 - a * x by rewrite -(pmulr_rgt0 _ dl) -e2.
have E : (1 - a * u) * (1 + b * z) = (1 + b * u) * (1 - a * x).
  have n : D 1 (l :: r :: V) != 0 by rewrite gt_eqF.
  apply: (mulfI n).
  have -> : D 1 (l :: r :: V) * ((1 - a * u) * (1 + b * z)) = D 1 (r :: V) * (1 + b * z) by rewrite mulrA -e3.
  have -> : D 1 (l :: r :: V) * ((1 + b * u) * (1 - a * x)) = D 1 (l :: V) * (1 - a * x) by rewrite mulrA -e4.
  by rewrite -e1 -e2.
pose K := a * (1 + b * z) + b * (1 - a * x).
have K0 : 0 < K by rewrite addr_gt0 // mulr_gt0.
have uK : u * K = b * z + a * x.
  apply/eqP; rewrite -subr_eq0; apply/eqP.
  have -> : u * K - (b * z + a * x) = (1 + b * u) * (1 - a * x) - (1 - a * u) * (1 + b * z) by rewrite /K; ring.
  by rewrite E subrr.
apply/andP; split; rewrite -subr_ge0 -(pmulr_rge0 _ K0).
  have -> : K * (u - x) = u * K - x * K by ring.
  rewrite uK; have -> : b * z + a * x - x * K = b * ((z - x) * (1 - a * x)) by rewrite /K; ring.
  by rewrite mulr_ge0 ?(ltW hr) // mulr_ge0 ?subr_ge0 // -subr_ge0 ltW.
have -> : K * (z - u) = z * K - u * K by ring.
rewrite uK; have -> : z * K - (b * z + a * x) = a * ((z - x) * (1 + b * z)) by rewrite /K; ring.
by rewrite mulr_ge0 ?(ltW a0) // mulr_ge0 ?subr_ge0 // ltW.
Qed.

(* one element of its side only: ell = -1/y *)
Lemma ell_single l s : (2 <= size s)%N -> ~~ two s -> two (l :: s) -> ell (l :: s) = - (y l)^-1.
Proof.
move=> z n t; have := step z t; rewrite (Done z n) => /esym/eqP; rewrite mulf_eq0 gt_eqF ?Dpos //= => /eqP h.
have yl := y_neq0 l.
have : y l * ell (l :: s) = -1 by apply/eqP; rewrite -subr_eq0 opprK addrC h.
by move=> e; apply: (mulfI yl); rewrite e mulrN divff.
Qed.

Definition Cl V := forall l r, lft l -> rgt r -> ell (l :: V) <= ell (r :: V).

Lemma pick_l V : two V -> exists l s, [/\ lft l, perm_eq V (l :: s) & has rgt s].
Proof.
case/andP=> /hasP[l lV hl] /hasP[r rV hr]; exists l, (rem l V); split=> //; first exact: perm_to_rem.
have : r \in l :: rem l V by rewrite -(perm_mem (perm_to_rem lV)).
rewrite inE => /orP[/eqP e|h]; last by apply/hasP; exists r.
by rewrite -e (rgt_lftF hr) in hl.
Qed.
Lemma pick_r V : two V -> exists r s, [/\ rgt r, perm_eq V (r :: s) & has lft s].
Proof.
case/andP=> /hasP[l lV hl] /hasP[r rV hr]; exists r, (rem r V); split=> //; first exact: perm_to_rem.
have : l \in r :: rem r V by rewrite -(perm_mem (perm_to_rem rV)).
rewrite inE => /orP[/eqP e|h]; last by apply/hasP; exists l.
by rewrite e (rgt_lftF hr) in hl.
Qed.

(* (iii) *)
Lemma up_from V r : (3 <= size V)%N -> two V -> rgt r ->
  (forall s, (size s < size V)%N -> (2 <= size s)%N -> two s -> Cl s) -> ell V <= ell (r :: V).
Proof.
move=> zV tV hr IH; have [l [s [hl pV hs]]] := pick_l tV.
have zs : size V = (size s).+1 by rewrite (perm_size pV).
have p2 : perm_eq (r :: V) (l :: r :: s).
  by rewrite (perm_trans (_ : perm_eq _ (r :: l :: s))) ?perm_cons // (perm_catCA [:: r] [:: l]).
rewrite (ell_perm pV) (ell_perm p2).
have z2 : (2 <= size s)%N by rewrite -ltnS -zs.
have hz : (size s < size V)%N by rewrite zs.
case: (boolP (two s)) => ts.
  by have /andP[] := between z2 ts hl hr (IH s hz z2 ts l r hl hr).
have nl : ~~ has lft s by move: ts; rewrite /two hs andbT.
rewrite !ell_single //.
- by rewrite ltnW.
- by rewrite /two /= (rgt_lftF hr) (negbTE nl).
- by rewrite /two /= hl hr orbT.
- by rewrite /two /= hl hs orbT.
Qed.
Lemma down_from V l : (3 <= size V)%N -> two V -> lft l ->
  (forall s, (size s < size V)%N -> (2 <= size s)%N -> two s -> Cl s) -> ell (l :: V) <= ell V.
Proof.
move=> zV tV hl IH; have [r [s [hr pV hs]]] := pick_r tV.
have zs : size V = (size s).+1 by rewrite (perm_size pV).
have p2 : perm_eq (l :: V) (l :: r :: s) by rewrite perm_cons.
have z2 : (2 <= size s)%N by rewrite -ltnS -zs.
have hz : (size s < size V)%N by rewrite zs.
rewrite (ell_perm pV) (ell_perm p2).
case: (boolP (two s)) => ts.
  by have /andP[] := between z2 ts hl hr (IH s hz z2 ts l r hl hr).
have nr : ~~ has rgt s by move: ts; rewrite /two hs.
have p3 : perm_eq (l :: r :: s) (r :: l :: s) by rewrite (perm_catCA [:: l] [:: r]).
rewrite (ell_perm p3) !ell_single //.
- by rewrite /two /= hr hs orbT.
- by rewrite ltnW.
- by rewrite /two /= (lft_rgtF hl) (negbTE nr) andbF.
- by rewrite /two /= hl hr orbT.
Qed.

Lemma claim V : (2 <= size V)%N -> two V -> Cl V.
Proof.
have [n] := ubnP (size V); elim: n V => // n IH V; rewrite ltnS => zn zV tV l r hl hr.
have IH' : forall s, (size s < size V)%N -> (2 <= size s)%N -> two s -> Cl s.
  by move=> s h1 h2 h3; apply: IH => //; apply: leq_trans zn.
case: (ltnP 2 (size V)) => [z3|z2].
  by apply: (le_trans (down_from z3 tV hl IH')); apply: up_from.
have zz : size V = 2%N by apply/eqP; rewrite eqn_leq z2 zV.
have [l1 [s [hl1 pV hs]]] := pick_l tV.
have : size s = 1%N by have := perm_size pV; rewrite zz => -[].
case: s pV hs => [|r1 [|? ?]] //= pV; rewrite orbF => hr1 _.
have pl : perm_eq (l :: V) (r1 :: [:: l; l1]).
  by rewrite (perm_trans (_ : perm_eq _ [:: l; l1; r1])) ?perm_cons // (perm_catC [:: l; l1] [:: r1]).
have pr : perm_eq (r :: V) (l1 :: [:: r; r1]).
  by rewrite (perm_trans (_ : perm_eq _ [:: r; l1; r1])) ?perm_cons // (perm_catCA [:: r] [:: l1]).
rewrite (ell_perm pl) (ell_perm pr) !ell_single //.
- by rewrite ler_opp2 (@le_trans _ _ 0) // ?invr_le0 ?invr_ge0 ltW.
- by rewrite /two /= (rgt_lftF hr) (rgt_lftF hr1).
- by rewrite /two /= hl1 hr orbT.
- by rewrite /two /= (lft_rgtF hl) (lft_rgtF hl1) andbF.
- by rewrite /two /= hl hr1 orbT.
Qed.

Lemma up V r : (3 <= size V)%N -> two V -> rgt r -> ell V <= ell (r :: V).
Proof. by move=> z t h; apply: up_from => // s _; apply: claim. Qed.
Lemma down V l : (3 <= size V)%N -> two V -> lft l -> ell (l :: V) <= ell V.
Proof. by move=> z t h; apply: down_from => // s _; apply: claim. Qed.

Definition LL W := D 2 W ^+ 2 - D 1 W * D 3 W.
Lemma LL_perm s t : perm_eq s t -> LL s = LL t.
Proof. by move=> p; rewrite /LL !(Dperm _ p). Qed.

Lemma LL_step e V : (3 <= size V)%N -> two V -> 0 <= LL (e :: V).
Proof.
move=> z t; have te := two_cons e t; have d := Dpos t; have de := Dpos te.
have E : ell (e :: V) - ell V = y e * LL (e :: V) / (D 1 (e :: V) * D 1 V).
  have h1 : D 1 V = D 1 (e :: V) + y e * D 2 (e :: V) by apply: tower; apply: ltnW.
  have h2 : D 2 V = D 2 (e :: V) + y e * D 3 (e :: V) by apply: tower.
  have n1 : D 1 (e :: V) != 0 by rewrite gt_eqF. have n2 : D 1 V != 0 by rewrite gt_eqF.
  move: n2; rewrite /ell /LL h1 h2 => n2; by field; rewrite n1 n2.
have dd : 0 < D 1 (e :: V) * D 1 V by rewrite mulr_gt0.
case/orP: (y_side e) => h.
  have : ell (e :: V) - ell V <= 0 by rewrite subr_le0 down.
  rewrite E pmulr_lle0 ?invr_gt0 // => h'.
  by rewrite -oppr_le0 -(pmulr_rle0 _ (_ : 0 < - y e)) ?oppr_gt0 // mulrNN.
have : 0 <= ell (e :: V) - ell V by rewrite subr_ge0 up.
by rewrite E pmulr_lge0 ?invr_gt0 // pmulr_rge0.
Qed.

(* Lemma 5 *)
Theorem logconcave W : (4 <= size W)%N -> two W -> 0 <= LL W.
Proof.
move=> z t; have [l [s [hl p hs]]] := pick_l t.
have zs : (3 <= size s)%N by move: z; rewrite (perm_size p).
case: (boolP (two s)) => ts; first by rewrite (LL_perm p) LL_step.
have nl : ~~ has lft s by move: ts; rewrite /two hs andbT.
case: s p hs zs nl {ts} => [|r [|r' s]] //= p hs zs nl.
have hr' : rgt r'.
  move: nl; rewrite !negb_or => /and3P[_ n _]; by have := y_side r'; rewrite (negbTE n).
have p2 : perm_eq W (r :: l :: r' :: s) by rewrite (perm_trans p) // (perm_catCA [:: l] [:: r]).
by rewrite (LL_perm p2) LL_step //= /two /= hl hr' orbT.
Qed.

(* Strict forms: ell_(V+l) < ell_(V+r) always; LL_W > 0 with two elements on each side *)
Lemma between_s V l r : (2 <= size V)%N -> two V -> lft l -> rgt r ->
  ell (l :: V) < ell (r :: V) ->
  ell (l :: V) < ell (l :: r :: V) < ell (r :: V).
Proof.
move=> zV tV hl hr xz.
set x := ell (l :: V) in xz *; set z := ell (r :: V) in xz *; set u := ell (l :: r :: V).
pose a := - y l; pose b := y r.
have a0 : 0 < a by rewrite oppr_gt0.
have tl := two_cons l tV; have tr := two_cons r tV; have tlr := two_cons l tr.
have e1 : D 1 V = D 1 (r :: V) * (1 + b * z) by apply: step.
have e2 : D 1 V = D 1 (l :: V) * (1 - a * x) by rewrite /a mulNr opprK; apply: step.
have e3 : D 1 (r :: V) = D 1 (l :: r :: V) * (1 - a * u).
  by rewrite /a mulNr opprK; apply: step => //; apply: ltnW.
have pm : perm_eq (l :: r :: V) (r :: l :: V) by rewrite (perm_catCA [:: l] [:: r]).
have e4 : D 1 (l :: V) = D 1 (l :: r :: V) * (1 + b * u).
  rewrite (Dperm 1 pm) /u (ell_perm pm); apply: step; first exact: ltnW.
  by rewrite -(two_perm pm).
have d0 := Dpos tV; have dl := Dpos tl; have dr := Dpos tr; have dlr := Dpos tlr.
have P0 : 0 < 1 + b * z by rewrite -(pmulr_rgt0 _ dr) -e1.
have Q0 : 0 < 1 - a * x by rewrite -(pmulr_rgt0 _ dl) -e2.
have E : (1 - a * u) * (1 + b * z) = (1 + b * u) * (1 - a * x).
  have n : D 1 (l :: r :: V) != 0 by rewrite gt_eqF.
  apply: (mulfI n).
  have -> : D 1 (l :: r :: V) * ((1 - a * u) * (1 + b * z)) = D 1 (r :: V) * (1 + b * z) by rewrite mulrA -e3.
  have -> : D 1 (l :: r :: V) * ((1 + b * u) * (1 - a * x)) = D 1 (l :: V) * (1 - a * x) by rewrite mulrA -e4.
  by rewrite -e1 -e2.
pose K := a * (1 + b * z) + b * (1 - a * x).
have K0 : 0 < K by rewrite addr_gt0 // mulr_gt0.
have uK : u * K = b * z + a * x.
  apply/eqP; rewrite -subr_eq0; apply/eqP.
  have -> : u * K - (b * z + a * x) = (1 + b * u) * (1 - a * x) - (1 - a * u) * (1 + b * z) by rewrite /K; ring.
  by rewrite E subrr.
have zx : 0 < z - x by rewrite subr_gt0.
apply/andP; split; rewrite -subr_gt0 -(pmulr_rgt0 _ K0).
  have -> : K * (u - x) = u * K - x * K by ring.
  rewrite uK; have -> : b * z + a * x - x * K = b * ((z - x) * (1 - a * x)) by rewrite /K; ring.
  by rewrite mulr_gt0 // mulr_gt0.
have -> : K * (z - u) = z * K - u * K by ring.
rewrite uK; have -> : z * K - (b * z + a * x) = a * ((z - x) * (1 + b * z)) by rewrite /K; ring.
by rewrite mulr_gt0 // mulr_gt0.
Qed.

Definition Cls V := forall l r, lft l -> rgt r -> ell (l :: V) < ell (r :: V).
Lemma count_side V : (count lft V + count rgt V)%N = size V.
Proof.
rewrite -(count_predC lft V); congr (_ + _)%N; apply: eq_count => l /=.
by case/orP: (y_side l) => h; rewrite ?(lft_rgtF h) ?(rgt_lftF h) ?h // -/(lft l).
Qed.
Lemma up_s V r : two V -> rgt r -> (1 < count lft V)%N ->
  (forall s, (size s < size V)%N -> (2 <= size s)%N -> two s -> Cls s) -> ell V < ell (r :: V).
Proof.
move=> tV hr cV IH; have [l [s [hl pV hs]]] := pick_l tV.
have zs : size V = (size s).+1 by rewrite (perm_size pV).
have p2 : perm_eq (r :: V) (l :: r :: s).
  by rewrite (perm_trans (_ : perm_eq _ (r :: l :: s))) ?perm_cons // (perm_catCA [:: r] [:: l]).
rewrite (ell_perm pV) (ell_perm p2).
have cs : has lft s.
  by move: cV; rewrite (permP pV) /= hl add1n ltnS has_count.
have ts : two s by rewrite /two cs hs.
have z2 : (2 <= size s)%N.
  by rewrite -count_side (@leq_add 1 1) // -has_count.
have hz : (size s < size V)%N by rewrite zs.
by have /andP[] := between_s z2 ts hl hr (IH s hz z2 ts l r hl hr).
Qed.
Lemma down_s V l : two V -> lft l -> (1 < count rgt V)%N ->
  (forall s, (size s < size V)%N -> (2 <= size s)%N -> two s -> Cls s) -> ell (l :: V) < ell V.
Proof.
move=> tV hl cV IH; have [r [s [hr pV hs]]] := pick_r tV.
have zs : size V = (size s).+1 by rewrite (perm_size pV).
have p2 : perm_eq (l :: V) (l :: r :: s) by rewrite perm_cons.
rewrite (ell_perm pV) (ell_perm p2).
have cs : has rgt s.
  by move: cV; rewrite (permP pV) /= hr add1n ltnS has_count.
have ts : two s by rewrite /two cs hs.
have z2 : (2 <= size s)%N.
  by rewrite -count_side (@leq_add 1 1) // -has_count.
have hz : (size s < size V)%N by rewrite zs.
by have /andP[] := between_s z2 ts hl hr (IH s hz z2 ts l r hl hr).
Qed.

Lemma claim_s V : (2 <= size V)%N -> two V -> Cls V.
Proof.
have [n] := ubnP (size V); elim: n V => // n IH V; rewrite ltnS => zn zV tV l r hl hr.
have IH' : forall s, (size s < size V)%N -> (2 <= size s)%N -> two s -> Cls s.
  by move=> s h1 h2 h3; apply: IH => //; apply: leq_trans zn.
case: (ltnP 2 (size V)) => [z3|z2].
  case: (ltnP 1 (count lft V)) => cl.
    by apply: (le_lt_trans (down z3 tV hl)); apply: up_s.
  have cr : (1 < count rgt V)%N.
    rewrite ltnNge; apply/negP => cr; move: z3; rewrite -count_side ltnNge => /negP; apply.
    exact: (leq_add cl cr).
  by apply: (lt_le_trans _ (up z3 tV hr)); apply: down_s.
have zz : size V = 2%N by apply/eqP; rewrite eqn_leq z2 zV.
have [l1 [s [hl1 pV hs]]] := pick_l tV.
have : size s = 1%N by have := perm_size pV; rewrite zz => -[].
case: s pV hs => [|r1 [|? ?]] //= pV; rewrite orbF => hr1 _.
have pl : perm_eq (l :: V) (r1 :: [:: l; l1]).
  by rewrite (perm_trans (_ : perm_eq _ [:: l; l1; r1])) ?perm_cons // (perm_catC [:: l; l1] [:: r1]).
have pr : perm_eq (r :: V) (l1 :: [:: r; r1]).
  by rewrite (perm_trans (_ : perm_eq _ [:: r; l1; r1])) ?perm_cons // (perm_catCA [:: r] [:: l1]).
rewrite (ell_perm pl) (ell_perm pr) !ell_single //.
- by rewrite ltr_opp2 (@lt_trans _ _ 0) // ?invr_lt0 ?invr_gt0.
- by rewrite /two /= (rgt_lftF hr) (rgt_lftF hr1).
- by rewrite /two /= hl1 hr orbT.
- by rewrite /two /= (lft_rgtF hl) (lft_rgtF hl1) andbF.
- by rewrite /two /= hl hr1 orbT.
Qed.

(* Lemma 5, strict with two knots on each side *)
Theorem logconcave_s W : (1 < count lft W)%N -> (1 < count rgt W)%N -> 0 < LL W.
Proof.
move=> cl cr; have t : two W by rewrite /two !has_count (ltnW cl) (ltnW cr).
have [e [V [he p hs]]] := pick_r t.
have clV : (1 < count lft V)%N by move: cl; rewrite (permP p) /= (rgt_lftF he).
have crV : (0 < count rgt V)%N by move: cr; rewrite (permP p) /= he.
have tV : two V by rewrite /two hs has_count.
have te := two_cons e tV; have d := Dpos tV; have de := Dpos te.
have z : (3 <= size V)%N by rewrite -count_side (@leq_add 2 1).
have E : ell (e :: V) - ell V = y e * LL (e :: V) / (D 1 (e :: V) * D 1 V).
  have h1 : D 1 V = D 1 (e :: V) + y e * D 2 (e :: V) by apply: tower; apply: ltnW.
  have h2 : D 2 V = D 2 (e :: V) + y e * D 3 (e :: V) by apply: tower.
  have n1 : D 1 (e :: V) != 0 by rewrite gt_eqF. have n2 : D 1 V != 0 by rewrite gt_eqF.
  move: n2; rewrite /ell /LL h1 h2 => n2; by field; rewrite n1 n2.
have dd : 0 < D 1 (e :: V) * D 1 V by rewrite mulr_gt0.
have : 0 < ell (e :: V) - ell V by rewrite subr_gt0; apply: up_s => // s _; apply: claim_s.
by rewrite E pmulr_lgt0 ?invr_gt0 // pmulr_rgt0 // (LL_perm p).
Qed.

(* Lemma 6 *)
Definition B s t := D 2 s * D 2 t - (D 1 s * D 3 t + D 3 s * D 1 t) / 2%:R.
Lemma B_perm s s' t t' : perm_eq s s' -> perm_eq t t' -> B s t = B s' t'.
Proof. by move=> p q; rewrite /B !(Dperm _ p) !(Dperm _ q). Qed.
Lemma BC s t : B s t = B t s. Proof. by rewrite /B; congr (_ - _ / _); ring. Qed.

Lemma two_pqq p q s : two (p :: q :: q :: s) = two (p :: q :: s).
Proof. by rewrite /two /=; do 2!case: (_ q); do 2!case: (_ p). Qed.

(* Lemma 6 *)
Theorem mixed p q s : (1 <= size s)%N -> two (p :: q :: s) ->
  0 <= B (p :: q :: q :: s) (p :: p :: q :: s).
Proof.
move=> z t.
have tf : two (p :: q :: q :: s) by rewrite two_pqq.
have tg : two (p :: p :: q :: s) by apply: two_cons.
set f := p :: q :: q :: s; set g := p :: p :: q :: s; set T := p :: q :: s.
have pf : perm_eq (q :: T) f by rewrite /T /f (perm_catCA [:: q] [:: p]).
have pg : perm_eq (q :: p :: p :: s) g.
  by rewrite /g -(perm_catCA [:: p; p] [:: q] s).
have e1 : D 1 T = D 1 f + y q * D 2 f by rewrite -!(Dperm _ pf); apply: tower.
have e1' : D 2 T = D 2 f + y q * D 3 f by rewrite -!(Dperm _ pf); apply: tower.
have e2 : D 1 T = D 1 g + y p * D 2 g by apply: tower.
have e2' : D 2 T = D 2 g + y p * D 3 g by apply: tower.
have e3 : D 1 (q :: q :: s) = D 1 f + y p * D 2 f by apply: tower.
have e4 : D 1 (p :: p :: s) = D 1 g + y q * D 2 g by rewrite -!(Dperm _ pg); apply: tower.
have T0 : 0 < D 1 T by apply: Dpos.
have key : 2%:R * D 1 T * B f g = D 1 (q :: q :: s) * LL g + D 1 (p :: p :: s) * LL f.
  have f2 : D 2 f = D 2 T - y q * D 3 f by rewrite e1' addrK.
  have g2 : D 2 g = D 2 T - y p * D 3 g by rewrite e2' addrK.
  have f1 : D 1 f = D 1 T - y q * D 2 f by rewrite e1 addrK.
  have g1 : D 1 g = D 1 T - y p * D 2 g by rewrite e2 addrK.
  rewrite e3 e4 /B /LL f1 g1 f2 g2.
  by field; rewrite ?pnatr_eq0.
rewrite -(pmulr_rge0 _ (_ : 0 < 2%:R * D 1 T)) ?mulr_gt0 ?ltr0n // key.
by rewrite addr_ge0 // mulr_ge0 ?Dge0 // logconcave.
Qed.


(* Lemma 8 and Theorem A, final inequality *)
Section Final.
Variables (V : seq I) (t0 : I) (c : I -> R).
Hypothesis Vuniq : uniq V.
Hypothesis Vtwo : two V.
Hypothesis c_ge0 : forall l, 0 <= c l.
Notation U := (t0 :: V).

Lemma sizeV : (2 <= size V)%N.
Proof.
have [l [s [_ p hs]]] := pick_l Vtwo; rewrite (perm_size p).
by case: s hs {p}.
Qed.
Lemma sizeU : (3 <= size U)%N. Proof. by rewrite /= ltnS sizeV. Qed.
Lemma Utwo : two U. Proof. exact: two_cons. Qed.

Lemma Bpos l m q : m \in V -> q \in V -> 0 <= B (l :: m :: U) (l :: q :: U).
Proof.
move=> mV qV; case: (eqVneq m q) => [<-|mq].
  have -> : B (l :: m :: U) (l :: m :: U) = LL (l :: m :: U).
    by rewrite /B /LL; field; rewrite ?pnatr_eq0.
  by apply: logconcave; [rewrite /= !ltnS (leq_trans _ sizeV) | do 2!apply: two_cons; apply: Utwo].
have qr : q \in rem m V by rewrite mem_rem_uniq // inE eq_sym mq.
pose rho := rem q (rem m V).
have pV : perm_eq V (m :: q :: rho).
  by rewrite (perm_trans (perm_to_rem mV)) // perm_cons perm_to_rem.
pose s := l :: t0 :: rho.
have pU (e : I) : perm_eq (l :: e :: U) (e :: m :: q :: s).
  rewrite (perm_trans (_ : perm_eq _ (l :: e :: t0 :: m :: q :: rho))) ?perm_cons //.
  rewrite (perm_trans (_ : perm_eq _ (e :: l :: t0 :: m :: q :: rho))) //; first by rewrite (perm_catCA [:: l] [:: e]).
  by rewrite perm_cons /s (perm_catCA [:: l; t0] [:: m; q] rho).
have p1 := pU m.
have p2 : perm_eq (l :: q :: U) (m :: q :: q :: s).
  by rewrite (perm_trans (pU q)) // (perm_catCA [:: q] [:: m]).
rewrite (B_perm p1 p2) BC; apply: mixed => //.
have : two (l :: U) by apply: two_cons; apply: Utwo.
suff /two_perm -> : perm_eq (l :: U) (m :: q :: s) by [].
rewrite (perm_trans (_ : perm_eq _ (l :: t0 :: m :: q :: rho))) ?perm_cons //.
by rewrite /s (perm_catCA [:: l; t0] [:: m; q] rho).
Qed.

Definition T l m q := D 2 (q :: U) * D 2 (l :: m :: U) - D 1 (q :: U) * D 3 (l :: m :: U).
Definition K l m q := (1 + (l == m)%:R) * T l m q.
Definition br l m q := K l m q + K m q l + K q l m.
Lemma br_rot l m q : br l m q = br m q l. Proof. by rewrite /br; ring. Qed.

Lemma swap2 j l m s : D j (l :: m :: s) = D j (m :: l :: s).
Proof. by apply: Dperm; rewrite (perm_catCA [:: l] [:: m]). Qed.
Lemma t1 j l m : (j <= 3)%N -> D j (l :: U) = D j (l :: m :: U) + y m * D j.+1 (l :: m :: U).
Proof.
move=> j3; rewrite !(swap2 _ l m); apply: tower.
by rewrite /= ltnS (leq_trans j3) // ltnS sizeV.
Qed.
Lemma t2 j l m q : (j <= 3)%N -> D j (l :: m :: U) = D j (l :: m :: q :: U) + y q * D j.+1 (l :: m :: q :: U).
Proof.
move=> j3.
have p i : D i (l :: m :: q :: U) = D i (q :: l :: m :: U).
  by apply: Dperm; rewrite (perm_catCA [:: l; m] [:: q]).
rewrite !p; apply: tower.
by rewrite /= ltnS (leq_trans j3) // ltnS (leq_trans sizeV).
Qed.
Lemma r3 j l m q : D j (l :: q :: m :: U) = D j (l :: m :: q :: U).
Proof. by apply: Dperm; rewrite perm_cons (perm_catCA [:: q] [:: m]). Qed.

Lemma T3 l m q : T l m q + T m q l + T q l m =
  B (l :: m :: U) (l :: q :: U) + B (l :: m :: U) (m :: q :: U) + B (l :: q :: U) (m :: q :: U).
Proof.
have E j : D j (m :: q :: l :: U) = D j (l :: m :: q :: U).
  by apply: Dperm; rewrite -(perm_catCA [:: l] [:: m; q]).
rewrite /T /B !(swap2 _ q l U).
rewrite (t1 q m) // (t1 q m (j:=1)) // (t1 l m) // (t1 l m (j:=1)) // (t1 m l) // (t1 m l (j:=1)) //.
rewrite !(swap2 _ m l U) !(swap2 _ q m U).
rewrite !(t2 l m q) // !(t2 m q l) // !(t2 l q m) // !(r3 _ l m q) !E.
move: (D 1 (l :: m :: q :: U)) (D 2 (l :: m :: q :: U)) (D 3 (l :: m :: q :: U)) (D 4 (l :: m :: q :: U)) (y l) (y m) (y q).
by move=> x1 x2 x3 x4 a b d; field; rewrite ?pnatr_eq0.
Qed.

Lemma T2 l q : T l l q + T l q l = 2%:R * B (l :: l :: U) (l :: q :: U).
Proof.
rewrite /T /B (t1 q l) // (t1 q l (j:=1)) // !(swap2 _ q l U) (t1 l l) // (t1 l l (j:=1)) //.
rewrite !(t2 l l q) // !(t2 l q l) // !(r3 _ l l q).
move: (D 1 (l :: l :: q :: U)) (D 2 (l :: l :: q :: U)) (D 3 (l :: l :: q :: U)) (D 4 (l :: l :: q :: U)) (y l) (y q).
by move=> x1 x2 x3 x4 a d; field; rewrite ?pnatr_eq0.
Qed.

Lemma T1 l : T l l l = LL (l :: l :: U).
Proof. by rewrite /T /LL (t1 l l) // (t1 l l (j:=1)) //; ring. Qed.

Lemma TC l m q : T l m q = T m l q. Proof. by rewrite /T !(swap2 _ l m). Qed.

Lemma br_llq l q : l \in V -> q \in V -> l != q -> 0 <= br l l q.
Proof.
move=> lV qV n; rewrite /br /K eqxx (negbTE n) eq_sym (negbTE n) (TC q l l).
have -> : (1 + true%:R) * T l l q + (1 + false%:R) * T l q l + (1 + false%:R) * T l q l = 2%:R * (T l l q + T l q l) :> R by rewrite /=; ring.
by rewrite T2 !mulr_ge0 ?ler0n // Bpos.
Qed.

Lemma br_ge0 l m q : l \in V -> m \in V -> q \in V -> 0 <= br l m q.
Proof.
move=> lV mV qV.
case: (eqVneq l m) => [<-|lm].
  case: (eqVneq l q) => [<-|lq]; last exact: br_llq.
  rewrite /br /K eqxx T1.
  have h : 0 <= LL (l :: l :: U).
    by apply: logconcave; [rewrite /= !ltnS (leq_trans _ sizeV) | do 2!apply: two_cons; apply: Utwo].
  by rewrite !addr_ge0 // mulr_ge0 // addr_ge0 ?ler01 ?ler0n.
case: (eqVneq m q) => [<-|mq]; first by rewrite br_rot br_llq // eq_sym.
case: (eqVneq q l) => [->|ql]; first by rewrite -br_rot br_llq.
rewrite /br /K (negbTE lm) (negbTE mq) (negbTE ql).
have -> : (1 + false%:R) * T l m q + (1 + false%:R) * T m q l + (1 + false%:R) * T q l m =
   T l m q + T m q l + T q l m :> R by rewrite /=; ring.
rewrite T3; apply: addr_ge0; first (apply: addr_ge0; first exact: Bpos).
- have -> : B (l :: m :: U) (m :: q :: U) = B (m :: l :: U) (m :: q :: U).
    by apply: B_perm => //; rewrite (perm_catCA [:: l] [:: m]).
  exact: Bpos.
- have -> : B (l :: q :: U) (m :: q :: U) = B (q :: l :: U) (q :: m :: U).
    by apply: B_perm; rewrite ?(perm_catCA [:: l] [:: q]) ?(perm_catCA [:: m] [:: q]).
  exact: Bpos.
Qed.

Definition phi1 j := \sum_(q <- V) c q * D j (q :: U).
Definition phi2 j := \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * D j (l :: m :: U).

Lemma core_sum : 3%:R * (phi1 2 * phi2 2 - phi1 1 * phi2 3) =
  \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) c l * c m * c q * br l m q.
Proof.
pose F l m q := c l * c m * c q * K l m q.
have E : phi1 2 * phi2 2 - phi1 1 * phi2 3 = \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) F l m q.
  rewrite ![phi1 _ * _]mulrC /phi2 /phi1 !mulr_suml -sumrB; apply: eq_bigr => l _.
  rewrite !mulr_suml -sumrB; apply: eq_bigr => m _.
  rewrite !mulr_sumr -sumrB; apply: eq_bigr => q _.
  by rewrite /F /K /T; ring.
have R1 (H : I -> I -> I -> R) : \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) H m q l =
   \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) H l m q.
  rewrite exchange_big /=; apply: eq_bigr => m _; rewrite exchange_big /=; exact: eq_bigr.
pose S := \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) F l m q.
pose S' := \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) F m q l.
pose S'' := \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) F q l m.
have e1 : S' = S by apply: R1.
have e2 : S'' = S by rewrite -e1; apply: (R1 (fun l m q => F m q l)).
have E3 : 3%:R * S = \sum_(l <- V) \sum_(m <- V) \sum_(q <- V) c l * c m * c q * br l m q.
  have -> : 3%:R * S = S + S' + S'' by rewrite e1 e2; ring.
  rewrite /S /S' /S'' -!big_split /=; apply: eq_bigr => l _; rewrite -!big_split /=; apply: eq_bigr => m _.
  rewrite -!big_split /=; apply: eq_bigr => q _; rewrite /F /br; ring.
by rewrite E.
Qed.

(* Lemma 8, the inequality *)
Theorem core_inequality : 0 <= phi1 2 * phi2 2 - phi1 1 * phi2 3.
Proof.
rewrite -(pmulr_rge0 _ (_ : 0 < 3%:R :> R)) ?ltr0n // core_sum.
rewrite big_seq sumr_ge0 // => l lV; rewrite big_seq sumr_ge0 // => m mV; rewrite big_seq sumr_ge0 // => q qV.
by rewrite mulr_ge0 ?br_ge0 // !mulr_ge0.
Qed.

Lemma sum_gt0 (s : seq I) (F : I -> R) l : l \in s -> (forall m, m \in s -> 0 <= F m) -> 0 < F l -> 0 < \sum_(m <- s) F m.
Proof.
move=> ls h hl; rewrite (perm_big _ (perm_to_rem ls)) big_cons /=; apply: ltr_paddr => //.
by rewrite big_seq sumr_ge0 // => m /mem_rem; apply: h.
Qed.

(* the same, strict *)
Theorem core_strict l : l \in V -> 0 < c l -> (1 < count lft (l :: l :: U))%N -> (1 < count rgt (l :: l :: U))%N ->
  0 < phi1 2 * phi2 2 - phi1 1 * phi2 3.
Proof.
move=> lV cl h1 h2; rewrite -(pmulr_rgt0 _ (_ : 0 < 3%:R :> R)) ?ltr0n // core_sum.
have t0_ a b q : a \in V -> b \in V -> q \in V -> 0 <= c a * c b * c q * br a b q.
  by move=> *; rewrite mulr_ge0 ?br_ge0 // !mulr_ge0.
apply: (sum_gt0 lV) => [m mV|]; first by rewrite big_seq sumr_ge0 // => q qV; rewrite big_seq sumr_ge0 // => *; apply: t0_.
apply: (sum_gt0 lV) => [m mV|]; first by rewrite big_seq sumr_ge0 // => *; apply: t0_.
apply: (sum_gt0 lV) => [m mV|]; first exact: t0_.
rewrite mulr_gt0 ?mulr_gt0 // /br /K eqxx T1.
have h : 0 < LL (l :: l :: U) by apply: logconcave_s.
have k : 0 < (1 + true%:R) * LL (l :: l :: U) by rewrite mulr_gt0 // addr_gt0 ?ltr01 // ltr0n.
by rewrite !addr_gt0.
Qed.

(* Theorem A in the gauge of the far knot t0 (its y is constant, c = 0 for it):
   the two first and second derivatives of C_V and C_(V+0), written by Lemma 7 *)
Theorem theoremA : 0 < y t0 ->
  let A0 := \sum_(q <- V) c q * D 1 (q :: V) in
  let A0' := \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * D 2 (l :: m :: V) in
  let A1 := phi1 1 in let A1' := phi2 2 in 0 <= A0 * A1' - A0' * A1.
Proof.
move=> b0 /=.
have P (l : I) j : (j <= 2)%N -> D j (l :: V) = D j (l :: U) + y t0 * D j.+1 (l :: U).
  move=> j2; rewrite !(swap2 _ l t0); apply: tower; by rewrite /= ltnS (leq_trans j2) // sizeV.
have Q (l m : I) j : (j <= 2)%N -> D j (l :: m :: V) = D j (l :: m :: U) + y t0 * D j.+1 (l :: m :: U).
  move=> j2; have p i : D i (l :: m :: U) = D i (t0 :: l :: m :: V).
    by apply: Dperm; rewrite (perm_catCA [:: l; m] [:: t0]).
  rewrite !p; apply: tower; by rewrite /= ltnS (leq_trans j2) // (leq_trans sizeV).
have -> : \sum_(q <- V) c q * D 1 (q :: V) = phi1 1 + y t0 * phi1 2.
  rewrite /phi1 mulr_sumr -big_split /=; apply: eq_bigr => q _; rewrite P //; ring.
have -> : \sum_(l <- V) \sum_(m <- V) c l * c m * (1 + (l == m)%:R) * D 2 (l :: m :: V) = phi2 2 + y t0 * phi2 3.
  rewrite /phi2 mulr_sumr -big_split /=; apply: eq_bigr => l _.
  rewrite mulr_sumr -big_split /=; apply: eq_bigr => m _; rewrite Q //; ring.
have -> : (phi1 1 + y t0 * phi1 2) * phi2 2 - (phi2 2 + y t0 * phi2 3) * phi1 1 =
  y t0 * (phi1 2 * phi2 2 - phi1 1 * phi2 3) by ring.
by rewrite mulr_ge0 ?(ltW b0) // core_inequality.
Qed.
End Final.
End Core.
