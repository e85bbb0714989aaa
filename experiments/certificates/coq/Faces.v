(** A witness: a point of a face. And a cut: the triangles of a face hold all its points. *)
Require Import List ZArith QArith Lia Lqa Setoid.
From Certificates Require Import Space Exact.
Import ListNotations.
Open Scope Z_scope.

Definition zface := list (list grid).

(** The face whose corners are at the places of the integers. *)
Definition image (place_of : grid -> point) (f : zface) : face := map (map place_of) f.

Definition face_over (u : positive) : zface -> face := image (over u).

Definition is_zero (v : grid) : bool := (vx v =? 0) && (vy v =? 0) && (vz v =? 0).
Definition equal (p q : grid) : bool := (vx p =? vx q) && (vy p =? vy q) && (vz p =? vz q).

Definition zturn (n u a b : grid) : Z :=
  match zdet n u a ?= 0, zdet n u b ?= 0, zdet n a b ?= 0 with
  | Lt, Gt, Gt => 1
  | Gt, Lt, Lt => -1
  | _, _, _ => 0
  end.

(** The face seen from p. *)
Definition view (up : positive) (p : grid) (uf : positive) (f : zface) : zface := map (map (seen up p uf)) f.

(** Why a face holds a point: it is at n/d of the way along an edge, or its winding number is counted with this normal and this ray. *)
Inductive holder :=
| On_edge (n : Z) (d : positive)
| In_plane (normal ray : grid).

Definition is_between (n : Z) (d up : positive) (p : grid) (uf : positive) (e : grid * grid) : bool :=
  let (a, b) := e in
  equal (ztimes (Zpos uf * Zpos d) p)
        (let c x y := ((Zpos d - n) * x + n * y) * Zpos up in Vec (c (vx a) (vx b)) (c (vy a) (vy b)) (c (vz a) (vz b))).

Definition check_on_face (h : holder) (up : positive) (p : grid) (uf : positive) (f : zface) : bool :=
  match h with
  | On_edge n d => (0 <=? n) && (n <=? Zpos d) && existsb (is_between n d up p uf) (edges f)
  | In_plane n u =>
      let g := view up p uf f in
      negb (is_zero n) && (zdot n u =? 0) && forallb (fun v => (zdot n v =? 0) && negb (zdet n u v =? 0)) (concat g) &&
      negb (sum (fun e => zturn n u (fst e) (snd e)) (edges g) =? 0)
  end.

(** A bool is true: what that says. *)
Ltac bools := repeat match goal with
  | H : _ && _ = true |- _ => apply andb_prop in H; destruct H
  | H : negb _ = true |- _ => apply Bool.negb_true_iff in H
  | H : (_ =? _) = true |- _ => apply Z.eqb_eq in H
  | H : (_ =? _) = false |- _ => apply Z.eqb_neq in H
  | H : (_ <=? _) = true |- _ => apply Z.leb_le in H
  | H : (_ <? _) = true |- _ => apply Z.ltb_lt in H
  end.

Lemma steps_map {S T} (g : S -> T) first (l : list S) : steps (g first) (map g l) = map (fun e => (g (fst e), g (snd e))) (steps first l).
Proof. induction l as [|p rest IH]; simpl; [reflexivity|]. rewrite IH. destruct rest; reflexivity. Qed.

Lemma edges_map {S T} (g : S -> T) (f : list (list S)) : edges (map (map g) f) = map (fun e => (g (fst e), g (snd e))) (edges f).
Proof.
  unfold edges. induction f as [|l f IH]; [reflexivity|]. simpl flat_map. rewrite map_app, IH. f_equal.
  destruct l as [|first l]; [reflexivity|]. exact (steps_map g first (first :: l)).
Qed.

Lemma sum_map {S T} (term : T -> Z) (g : S -> T) l : sum term (map g l) = sum (fun x => term (g x)) l.
Proof. induction l; simpl; congruence. Qed.

Lemma sum_ext {T} (f g : T -> Z) l : (forall x, In x l -> f x = g x) -> sum f l = sum g l.
Proof. induction l; simpl; intros H; [reflexivity|]. rewrite H, IHl; auto. Qed.

Lemma sum_app {T} (f : T -> Z) l m : sum f (l ++ m) = sum f l + sum f m.
Proof. induction l; simpl; lia. Qed.

Lemma sum_nonzero {T} (f : T -> Z) l : sum f l <> 0 -> exists x, In x l /\ f x <> 0.
Proof.
  induction l as [|x l IH]; simpl; intros H; [lia|].
  destruct (Z.eq_dec (f x) 0); [|exists x; auto]. destruct IH as (y & ? & ?); [lia|]. exists y; auto.
Qed.

Lemma edge_corners {T} (f : list (list T)) e : In e (edges f) -> In (fst e) (concat f) /\ In (snd e) (concat f).
Proof.
  unfold edges. intros H. apply in_flat_map in H as (l & in_f & in_l).
  assert (both : In (fst e) l /\ In (snd e) l).
  { unfold edges_of_loop in in_l. destruct l as [|first l]; [contradiction|].
    assert (general : forall corners, In e (steps first corners) -> In (fst e) corners /\ (snd e = first \/ In (snd e) corners)).
    { induction corners as [|p rest IH]; simpl; intros H; [contradiction|]. destruct H as [<-|H].
      - destruct rest; simpl; auto.
      - destruct (IH H) as (? & [?|?]); auto. }
    destruct (general _ in_l) as (? & [->|?]); split; auto. left; reflexivity. }
  split; apply in_concat; exists l; intuition.
Qed.

#[global] Instance turn_same : Proper (same ==> same ==> same ==> same ==> eq) turn.
Proof.
  intros n n' nn u u' uu a a' aa b b' bb. unfold turn.
  assert (Ha : (det n u a ?= 0)%Q = (det n' u' a' ?= 0)%Q) by (rewrite nn, uu, aa; reflexivity).
  assert (Hb : (det n u b ?= 0)%Q = (det n' u' b' ?= 0)%Q) by (rewrite nn, uu, bb; reflexivity).
  assert (Hc : (det n a b ?= 0)%Q = (det n' a' b' ?= 0)%Q) by (rewrite nn, aa, bb; reflexivity).
  rewrite Ha, Hb, Hc. reflexivity.
Qed.

Lemma zturn_is_turn un uu n u up p uf a b :
  turn (over un n) (over uu u) (minus (over uf a) (over up p)) (minus (over uf b) (over up p)) = zturn n u (seen up p uf a) (seen up p uf b).
Proof. rewrite <- !seen_over. unfold turn, zturn. rewrite !zdet_sign. reflexivity. Qed.

Lemma zturns_are_turns un uu n u up p uf f :
  turns (over un n) (over uu u) (face_over uf f) (over up p) = sum (fun e => zturn n u (fst e) (snd e)) (edges (view up p uf f)).
Proof.
  unfold turns, face_over, image, view. rewrite !edges_map, !sum_map. apply sum_ext. intros e _. simpl. apply zturn_is_turn.
Qed.

Lemma Qcompare_zero x z : (x ?= 0)%Q = (z ?= 0) -> (x == 0)%Q <-> z = 0.
Proof. intros H. rewrite Qeq_alt, H. apply Z.compare_eq_iff. Qed.

Lemma zdot_zero m u v : (dot (over 1 m) (over u v) == 0)%Q <-> zdot m v = 0.
Proof. apply Qcompare_zero, zdot_sign. Qed.

Lemma zdet_zero ua ub uc a b c : (det (over ua a) (over ub b) (over uc c) == 0)%Q <-> zdet a b c = 0.
Proof. apply Qcompare_zero, zdet_sign. Qed.

Lemma equal_same p q : equal p q = true -> p = q.
Proof. destruct p, q. unfold equal; simpl. intros. bools. congruence. Qed.

Lemma over_nonzero u n : is_zero n = false -> ~ same (over u n) (Vec 0 0 0)%Q.
Proof.
  intros H (Zx & Zy & Zz). unfold Qeq in *; simpl in *. rewrite Z.mul_1_r in *.
  unfold is_zero in H. rewrite Zx, Zy, Zz in H. discriminate.
Qed.

Lemma between_coordinate n d up uf x a b : Zpos uf * Zpos d * x = ((Zpos d - n) * a + n * b) * Zpos up ->
  (x # up == (1 - (n # d)) * (a # uf) + (n # d) * (b # uf))%Q.
Proof.
  intros H. unfold Qminus, Qeq, Qplus, Qmult, Qopp; cbn [Qnum Qden]; rewrite ?Pos2Z.inj_mul.
  transitivity (Zpos uf * Zpos d * x * (Zpos d * Zpos uf)); [ring | rewrite H; ring].
Qed.

Theorem on_face_sound h up p uf f : check_on_face h up p uf f = true -> on_face (face_over uf f) (over up p).
Proof.
  destruct h as [n d|n u]; simpl; intros accepted; bools.
  - left. apply existsb_exists in H0 as ((a & b) & is_edge & at_p).
    exists (over uf a, over uf b). split.
    + unfold face_over, image. rewrite edges_map. apply in_map_iff. exists (a, b). auto.
    + apply equal_same in at_p. unfold ztimes in at_p. destruct p as [x y z], a as [ax ay az], b as [bx by_ bz].
      simpl in at_p. injection at_p as Hx Hy Hz.
      apply (Between _ (over uf (Vec ax ay az)) (over uf (Vec bx by_ bz)) _ (n # d));
        [eapply Corner; [left|]; reflexivity | eapply Corner; [right; left|]; reflexivity | | | ].
      * unfold Qle; simpl; lia.
      * unfold Qle; simpl; lia.
      * repeat split; apply between_coordinate; assumption.
  - right. exists (turns (over 1 n) (over 1 u) (face_over uf f) (over up p)). split.
    + exists (over 1 n), (over 1 u). split; [|split; [|split; [|reflexivity]]].
      * exact (over_nonzero 1 n H).
      * apply zdot_zero; assumption.
      * intros v Hv. unfold face_over, image in Hv. rewrite <- concat_map in Hv. apply in_map_iff in Hv as (zv & <- & Hv).
        rewrite forallb_forall in H1. specialize (H1 (seen up p uf zv)).
        unfold view in H1. rewrite <- concat_map in H1. specialize (H1 (in_map _ _ _ Hv)). bools.
        rewrite <- seen_over, zdot_zero, zdet_zero. auto.
    + rewrite zturns_are_turns. assumption.
Qed.

(** ** The points of a face lie within the hull of its corners *)

Open Scope Q_scope.

Lemma negative_or_positive (x : Q) : ~ x == 0 -> x < 0 \/ 0 < x.
Proof. intros H. destruct (Q_dec x 0) as [[?|?]|?]; auto. contradiction. Qed.

(** Three vectors that are normal to one that is not 0 have no volume. *)
Lemma flat n a b c : ~ same n (Vec 0 0 0) -> dot n a == 0 -> dot n b == 0 -> dot n c == 0 -> det a b c == 0.
Proof.
  intros nonzero Ha Hb Hc.
  assert (Hx : vx n * det a b c == dot n a * (vx (cross b c)) + dot n b * vx (cross c a) + dot n c * vx (cross a b))
    by (unfold det, dot, cross; simpl; ring).
  assert (Hy : vy n * det a b c == dot n a * (vy (cross b c)) + dot n b * vy (cross c a) + dot n c * vy (cross a b))
    by (unfold det, dot, cross; simpl; ring).
  assert (Hz : vz n * det a b c == dot n a * (vz (cross b c)) + dot n b * vz (cross c a) + dot n c * vz (cross a b))
    by (unfold det, dot, cross; simpl; ring).
  rewrite Ha, Hb, Hc in Hx, Hy, Hz.
  destruct (Q_dec (det a b c) 0) as [[less|more]|]; [| |assumption]; exfalso; apply nonzero; repeat split; simpl; nra.
Qed.

(** An edge that crosses the line of the ray has a point on it: s u, where s has the sign of the turn. *)
Lemma edge_meets_line n u a b : ~ same n (Vec 0 0 0) -> dot n u == 0 -> dot n a == 0 -> dot n b == 0 ->
  det n u a < 0 -> 0 < det n u b -> hull [a; b] (times (det n a b / (det n u b - det n u a)) u).
Proof.
  intros nonzero Hu Ha Hb right left.
  assert (no_volume := flat n u a b nonzero Hu Ha Hb).
  assert (width : 0 < det n u b - det n u a) by lra.
  set (w := det n u b - det n u a) in *.
  apply (Between _ a b _ (- det n u a / w)).
  - apply (Corner _ a); [left|]; reflexivity.
  - apply (Corner _ b); [right; left|]; reflexivity.
  - apply Qle_shift_div_l; lra.
  - apply Qle_shift_div_r; unfold w; lra.
  - assert (nonzero_w : ~ w == 0) by lra.
    assert (coordinate : forall ua aa ba : Q, det n a b * ua == (w + det n u a) * aa - det n u a * ba ->
              det n a b / w * ua == (1 - - det n u a / w) * aa + - det n u a / w * ba)
      by (intros ua aa ba H; transitivity ((det n a b * ua) / w); [field; assumption|]; rewrite H; field; assumption).
    assert (whole : w + det n u a == det n u b) by (unfold w; ring).
    repeat split; unfold times, plus; cbn [vx vy vz]; apply coordinate; rewrite whole.
    + transitivity (det n u b * vx a - det n u a * vx b + det u a b * vx n); [unfold det, dot, cross; simpl; ring | rewrite no_volume; ring].
    + transitivity (det n u b * vy a - det n u a * vy b + det u a b * vy n); [unfold det, dot, cross; simpl; ring | rewrite no_volume; ring].
    + transitivity (det n u b * vz a - det n u a * vz b + det u a b * vz n); [unfold det, dot, cross; simpl; ring | rewrite no_volume; ring].
Qed.

(** Points s u with s of both signs, or one with s = 0, have the origin between them. *)
Lemma between_both corners u s t : hull corners (times s u) -> hull corners (times t u) -> 0 < s -> t <= 0 ->
  hull corners (Vec 0 0 0).
Proof.
  intros at_s at_t Hs Ht.
  apply (Between _ (times s u) (times t u) _ (s / (s - t))); auto.
  - apply Qle_shift_div_l; lra.
  - apply Qle_shift_div_r; lra.
  - repeat split; unfold plus, times; simpl; field; lra.
Qed.

(** Side of the line that an edge's end is on: 1 left of it, 0 right of it. *)
Definition side (n u v : point) : Z := match (det n u v ?= 0)%Q with Gt => 1%Z | _ => 0%Z end.

Definition back_turn (n u a b : point) : Z := (side n u b - side n u a - turn n u a b)%Z.

Lemma swapped (u a b : point) s : hull [b; a] (times s u) -> hull [a; b] (times s u).
Proof. apply hull_incl. intros v [<-|[<-|[]]]; simpl; auto. Qed.

Lemma det_swap n a b : det n b a == - det n a b.
Proof. unfold det, dot, cross; simpl; ring. Qed.

Section Points_on_the_line.
Variables n u a b : point.
Hypothesis nonzero : ~ same n (Vec 0 0 0).
Hypothesis Hu : dot n u == 0.
Hypothesis Ha : dot n a == 0.
Hypothesis Hb : dot n b == 0.

Lemma front_point : turn n u a b <> 0%Z -> exists s, 0 < s /\ hull [a; b] (times s u).
Proof.
  unfold turn. destruct (Qcompare_spec (det n u a) 0) as [A|A|A], (Qcompare_spec (det n u b) 0) as [B|B|B],
    (Qcompare_spec (det n a b) 0) as [C|C|C]; intros H; try congruence.
  - exists (det n a b / (det n u b - det n u a)). split; [apply Qlt_shift_div_l; lra | apply edge_meets_line; assumption].
  - exists (det n b a / (det n u a - det n u b)). split; [apply Qlt_shift_div_l; pose proof (det_swap n a b); lra |].
    apply swapped. apply edge_meets_line; assumption.
Qed.

Lemma back_point : det n u a < 0 \/ 0 < det n u a -> det n u b < 0 \/ 0 < det n u b -> back_turn n u a b <> 0%Z ->
  exists s, s <= 0 /\ hull [a; b] (times s u).
Proof.
  unfold back_turn, side, turn. intros off_a off_b.
  destruct (Qcompare_spec (det n u a) 0) as [A|A|A]; [exfalso; lra| |];
  (destruct (Qcompare_spec (det n u b) 0) as [B|B|B]; [exfalso; lra| |]);
    destruct (Qcompare_spec (det n a b) 0) as [C|C|C]; simpl; intros H; try congruence;
    try (exists (det n a b / (det n u b - det n u a)); split; [apply Qle_shift_div_r; lra | apply edge_meets_line; assumption]);
    (exists (det n b a / (det n u a - det n u b)); split; [apply Qle_shift_div_r; pose proof (det_swap n a b); lra |];
     apply swapped; apply edge_meets_line; assumption).
Qed.

End Points_on_the_line.

Lemma loops_close {T} (g : T -> Z) (f : list (list T)) : sum (fun e => (g (snd e) - g (fst e))%Z) (edges f) = 0%Z.
Proof.
  unfold edges. induction f as [|l f IH]; [reflexivity|]. simpl. rewrite sum_app, IH, Z.add_0_r.
  destruct l as [|first l]; [reflexivity|].
  assert (general : forall corners p, sum (fun e => (g (snd e) - g (fst e))%Z) (steps first (p :: corners)) = (g first - g p)%Z).
  { induction corners as [|q rest IHr]; intros p; simpl; [lia|]. specialize (IHr q). simpl in IHr. lia. }
  unfold edges_of_loop. rewrite general. lia.
Qed.

Lemma sum_minus {T} (f g : T -> Z) l : sum (fun x => (f x - g x)%Z) l = (sum f l - sum g l)%Z.
Proof. induction l; simpl; lia. Qed.

Lemma hull_translated f p q : hull (map (fun v => minus v p) f) q -> hull f (plus q p).
Proof.
  intros at_q. induction at_q as [v q inside qv|q r t s at_q IHq at_r IHr low high t_is].
  - apply in_map_iff in inside as (w & <- & inside). apply (Corner f w); [assumption|].
    rewrite qv. repeat split; unfold plus, minus; simpl; ring.
  - apply (Between f _ _ _ s IHq IHr low high). rewrite t_is. repeat split; unfold plus, times; simpl; ring.
Qed.

Theorem on_face_in_hull f p : on_face f p -> hull (concat f) p.
Proof.
  intros [(e & is_edge & at_p)|(w & (n & u & nonzero & Hu & corners & total) & w_nonzero)].
  - apply (hull_incl [fst e; snd e]); [|assumption]. destruct (edge_corners f e is_edge).
    intros v [<-|[<-|[]]]; assumption.
  - assert (flat_corner : forall v, In v (concat f) -> dot n (minus v p) == 0) by (intros; apply corners; assumption).
    assert (off_line : forall v, In v (concat f) -> det n u (minus v p) < 0 \/ 0 < det n u (minus v p))
      by (intros; apply negative_or_positive, corners; assumption).
    set (seen_corners := map (fun v => minus v p) (concat f)).
    assert (inside : forall e q, In e (edges f) -> hull [minus (fst e) p; minus (snd e) p] q -> hull seen_corners q).
    { intros e q is_edge. destruct (edge_corners f e is_edge). apply hull_incl.
      intros v [<-|[<-|[]]]; apply (in_map (fun v => minus v p)); assumption. }
    assert (front : exists e, In e (edges f) /\ turn n u (minus (fst e) p) (minus (snd e) p) <> 0%Z)
      by (apply (sum_nonzero (fun e => turn n u (minus (fst e) p) (minus (snd e) p))); unfold turns in total; congruence).
    assert (back : exists e, In e (edges f) /\ back_turn n u (minus (fst e) p) (minus (snd e) p) <> 0%Z).
    { apply (sum_nonzero (fun e => back_turn n u (minus (fst e) p) (minus (snd e) p))). unfold back_turn.
      rewrite (sum_minus (fun e => (side n u (minus (snd e) p) - side n u (minus (fst e) p))%Z)
                         (fun e => turn n u (minus (fst e) p) (minus (snd e) p))).
      rewrite (loops_close (fun v => side n u (minus v p))). unfold turns in total. lia. }
    destruct front as (e & is_edge & front). destruct back as (e' & is_edge' & back).
    destruct (edge_corners f e is_edge), (edge_corners f e' is_edge').
    destruct (front_point n u (minus (fst e) p) (minus (snd e) p)) as (s & Hs & at_s); auto.
    destruct (back_point n u (minus (fst e') p) (minus (snd e') p)) as (t & Ht & at_t); auto.
    apply (hull_same (concat f) (concat f) (plus (Vec 0 0 0) p) p); [|repeat split; simpl; ring |].
    + clear. induction (concat f); constructor; [reflexivity | assumption].
    + apply hull_translated. apply (between_both _ u s t); eauto.
Qed.
