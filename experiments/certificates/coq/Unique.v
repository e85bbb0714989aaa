(** The winding number of a closed body of triangles does not depend on the ray. *)
Require Import List ZArith QArith Lia Lqa Setoid Bool.
From Certificates Require Import Space Exact Faces Cuts Covers Claims Signs.
Import ListNotations.
Open Scope Q_scope.

(** ** A vector in general position *)

Lemma above_all (l : list Q) : exists t, 0 < t /\ forall x, In x l -> x < t.
Proof.
  induction l as [|y l (t & positive & above)]; [exists 1; split; [reflexivity | intros x []]|].
  destruct (Qlt_le_dec y t).
  - exists t. split; [assumption|]. intros x [<-|H]; auto.
  - exists (y + 1). split; [lra|]. intros x [<-|H]; [lra|]. specialize (above x H). lra.
Qed.

Lemma own_square n : ~ same n (Vec 0 0 0) -> 0 < dot n n.
Proof.
  intros H. assert (Hn := square_positive n). destruct (Qlt_le_dec 0 (dot n n)) as [|low]; [assumption|]. exfalso. apply H.
  unfold dot in *. assert (square : forall x : Q, 0 <= x * x) by (intros; nra).
  assert (A := square (vx n)). assert (B := square (vy n)). assert (C := square (vz n)).
  repeat split; simpl; nra.
Qed.

Lemma same_dec p q : {same p q} + {~ same p q}.
Proof.
  unfold same. destruct (Qeq_dec (vx p) (vx q)), (Qeq_dec (vy p) (vy q)), (Qeq_dec (vz p) (vz q)); [left; auto|right..]; intros (? & ? & ?); auto.
Qed.

(** One that is normal to none of the vectors, but to null ones. *)
Lemma general_vector (l : list point) : exists e, forall n, In n l -> dot e n == 0 -> same n (Vec 0 0 0).
Proof.
  induction l as [|n l (e & general)]; [exists (Vec 0 0 0); intros n []|].
  destruct (same_dec n (Vec 0 0 0)) as [null|nonzero]; [exists e; intros m [<-|H]; auto|].
  destruct (above_all (map (fun m => - dot e m / dot n m) (n :: l))) as (t & positive & above).
  exists (plus e (times t n)). intros m m_in normal.
  assert (expanded : dot e m + t * dot n m == 0) by (rewrite <- normal; unfold dot, plus, times; simpl; ring).
  specialize (above (- dot e m / dot n m) (in_map (fun m => - dot e m / dot n m) _ _ m_in)).
  destruct (Qeq_dec (dot n m) 0) as [Z|N].
  - destruct m_in as [<-|m_in]; [assert (P := own_square n nonzero); lra|]. apply (general m m_in). rewrite Z in expanded. lra.
  - exfalso. assert (t == - dot e m / dot n m); [|lra].
    assert (E : dot e m == - (t * dot n m)) by lra. rewrite E. field. exact N.
Qed.

(** ** Vectors on a line *)

Definition on_line (p q : point) : Prop := same (cross p q) (Vec 0 0 0).

Lemma on_line_det p q r : on_line p q ->
  det p q r == 0 /\ det r p q == 0 /\ det q r p == 0 /\ det q p r == 0 /\ det r q p == 0 /\ det p r q == 0.
Proof.
  intros H.
  assert (Z : dot (cross p q) r == 0) by (unfold on_line in H; rewrite H; unfold dot; simpl; ring).
  repeat split; [transitivity (dot (cross p q) r) | transitivity (dot (cross p q) r) | transitivity (dot (cross p q) r) |
    transitivity (- dot (cross p q) r) | transitivity (- dot (cross p q) r) | transitivity (- dot (cross p q) r)];
    try (rewrite Z; reflexivity); unfold det, dot, cross; simpl; ring.
Qed.

Ltac from_line H := match goal with |- det ?x ?y ?z == 0 =>
  first [destruct (on_line_det _ _ x H) as (? & ? & ? & ? & ? & ?); assumption | destruct (on_line_det _ _ y H) as (? & ? & ? & ? & ? & ?); assumption |
         destruct (on_line_det _ _ z H) as (? & ? & ? & ? & ? & ?); assumption] end.

Lemma both_on_line d p q r : ~ same d (Vec 0 0 0) -> on_line d p -> on_line d q -> det p q r == 0.
Proof.
  intros nonzero (Px & Py & Pz) (Qx & Qy & Qz). unfold cross in *; simpl in *.
  assert (Dx : vx d * vx d * det p q r == 0).
  { assert (A : same (times (vx d) p) (times (vx p) d)) by (repeat split; unfold times; simpl; lra).
    assert (B : same (times (vx d) q) (times (vx q) d)) by (repeat split; unfold times; simpl; lra).
    transitivity (det (times (vx d) p) (times (vx d) q) r); [unfold det, dot, cross, times; simpl; ring|].
    rewrite A, B. unfold det, dot, cross, times; simpl; ring. }
  assert (Dy : vy d * vy d * det p q r == 0).
  { assert (A : same (times (vy d) p) (times (vy p) d)) by (repeat split; unfold times; simpl; lra).
    assert (B : same (times (vy d) q) (times (vy q) d)) by (repeat split; unfold times; simpl; lra).
    transitivity (det (times (vy d) p) (times (vy d) q) r); [unfold det, dot, cross, times; simpl; ring|].
    rewrite A, B. unfold det, dot, cross, times; simpl; ring. }
  assert (Dz : vz d * vz d * det p q r == 0).
  { assert (A : same (times (vz d) p) (times (vz p) d)) by (repeat split; unfold times; simpl; lra).
    assert (B : same (times (vz d) q) (times (vz q) d)) by (repeat split; unfold times; simpl; lra).
    transitivity (det (times (vz d) p) (times (vz d) q) r); [unfold det, dot, cross, times; simpl; ring|].
    rewrite A, B. unfold det, dot, cross, times; simpl; ring. }
  assert (P := own_square d nonzero).
  assert (S : dot d d * det p q r == 0) by (unfold dot; rewrite !Qmult_plus_distr_l, Dx, Dy, Dz; reflexivity).
  apply Qmult_integral in S as [S|S]; [lra | assumption].
Qed.

(** ** What a triangle adds *)

(** By signs, as one sees the corners from the origin. *)
Definition hits (d a b c : point) : Z := hit (sign (det d a b)) (sign (det d b c)) (sign (det d c a)) (sign (det a b c)).
Definition generic (d a b c : point) : Prop := is_generic (sign (det d a b)) (sign (det d b c)) (sign (det d c a)) (sign (det a b c)) = true.

Lemma sign_not_null x : ~ x == 0 -> sign x <> Eq.
Proof. unfold sign. intros H E. apply H. apply Qeq_alt. exact E. Qed.

Lemma sign_positive x : 0 < x -> sign x = Gt.
Proof. unfold sign. intros H. rewrite <- Qgt_alt. exact H. Qed.

Lemma passes_hits m d a b c : dot m d <= 0 -> 0 < dot m a -> 0 < dot m b -> 0 < dot m c -> generic d a b c /\ hits d a b c = 0%Z.
Proof.
  intros backward A B C. apply (passing_is_generic _ _ _ _ (sign (dot m d))).
  - unfold sign. destruct (Qcompare_spec (dot m d) 0); try discriminate. lra.
  - rewrite <- sign_product. apply (agrees_sound (dot m c) (dot m a) (dot m b)); try assumption.
    unfold det, dot, cross; simpl; ring.
Qed.

Lemma turn_is_turn_sign d u a b : turn d u a b = turn_sign (sign (det d u a)) (sign (det d u b)) (sign (det d a b)).
Proof. reflexivity. Qed.

Lemma off_edge_sound x y z : ~ z == 0 \/ 0 < x * y -> off_edge (sign x) (sign y) (sign z) = true.
Proof.
  unfold off_edge. intros [H|H].
  - apply sign_not_null in H. destruct (sign z); try reflexivity. contradiction.
  - rewrite <- sign_product, (sign_positive _ H). apply orb_true_r.
Qed.

Lemma crosses_hits n h u d a b c : 0 < h -> 0 < dot n d -> dot n a == h -> dot n b == h -> dot n c == h ->
  ~ det d u a == 0 -> ~ det d u b == 0 -> ~ det d u c == 0 ->
  ~ det d a b == 0 \/ 0 < det d u a * det d u b -> ~ det d b c == 0 \/ 0 < det d u b * det d u c -> ~ det d c a == 0 \/ 0 < det d u c * det d u a ->
  generic d a b c /\ hits d a b c = (turn d u a b + turn d u b c + turn d u c a)%Z.
Proof.
  intros high forward Ha Hb Hc Ua Ub Uc Oab Obc Oca. rewrite !turn_is_turn_sign.
  apply crossing_is_generic; try (apply sign_not_null; assumption); try (apply off_edge_sound; assumption).
  - rewrite <- !sign_product. apply may_cancel_sound. unfold det, dot, cross; simpl; ring.
  - set (r := h / dot n d).
    assert (R : 0 < r) by (apply Qlt_shift_div_l; lra).
    apply (agrees_sound r r r); try assumption.
    assert (volume : dot n d * det a b c == h * (det d a b + det d b c + det d c a)).
    { transitivity (dot n c * det d a b + dot n a * det d b c + dot n b * det d c a); [unfold det, dot, cross; simpl; ring|].
      rewrite Ha, Hb, Hc. ring. }
    assert (E : det a b c == h * (det d a b + det d b c + det d c a) / dot n d) by (rewrite <- volume; field; lra).
    rewrite E. unfold r. field. lra.
Qed.

(** What the triangle adds to the winding number of p along d is what its signs say. *)
Lemma adds_is_hits p d a b c w : adds p d [[a; b; c]] w ->
  generic d (minus a p) (minus b p) (minus c p) /\ hits d (minus a p) (minus b p) (minus c p) = w.
Proof.
  intros [((m & backward & ahead) & ->)|(n & h & u & high & forward & corners & off & total)].
  - apply (passes_hits m); [assumption|..]; apply ahead; simpl; auto.
  - destruct (corners a) as (Ha & Ua); [simpl; auto|]. destruct (corners b) as (Hb & Ub); [simpl; auto|]. destruct (corners c) as (Hc & Uc); [simpl; auto|].
    destruct (crosses_hits n h u d (minus a p) (minus b p) (minus c p)) as (G & H); try assumption.
    + apply (off (a, b)). simpl; auto.
    + apply (off (b, c)). simpl; auto.
    + apply (off (c, a)). simpl; auto.
    + split; [assumption|]. rewrite H. unfold turns in total. simpl in total. lia.
Qed.

(** ** Independence of the ray *)

(** What an edge adds, with e as the third corner. *)
Definition edge_adds (d e a b : point) : Z := hit (sign (det d e a)) (sign (det d a b)) (CompOpp (sign (det d e b))) (sign (det e a b)).

Definition holds_origin (e a b c : point) : Z := encloses (sign (det a b c)) (sign (det e b c)) (sign (det e c a)) (sign (det e a b)).

(** e is in general position to d and the corners. *)
Definition in_general (e : point) (l : list point) : Prop := forall x y, In x l -> In y l -> det e x y == 0 -> on_line x y.

Lemma null_sign x : is_null (sign x) = true -> x == 0.
Proof. unfold sign. intros H. apply Qeq_alt. destruct (x ?= 0); [reflexivity | discriminate | discriminate]. Qed.

Lemma sign_null x : x == 0 -> is_null (sign x) = true.
Proof. unfold sign. intros H. apply Qeq_alt in H. rewrite H. reflexivity. Qed.

Lemma turned_pair e x y : det x e y == 0 -> det e x y == 0.
Proof. intros H. transitivity (- det x e y); [unfold det, dot, cross; simpl; ring | rewrite H; reflexivity]. Qed.

Lemma triangle_adds d e a b c : ~ same d (Vec 0 0 0) -> in_general e [d; a; b; c] -> generic d a b c ->
  hits d a b c = (holds_origin e a b c + (edge_adds d e a b + edge_adds d e b c + edge_adds d e c a))%Z.
Proof.
  intros nonzero general is_gen.
  assert (line : forall x y, In x [d; a; b; c] -> In y [d; a; b; c] -> det e x y == 0 -> on_line x y) by exact general.
  assert (A := four_triangles (sign (det d a b)) (sign (det d b c)) (sign (det d c a)) (sign (det a b c)) (sign (det d e a)) (sign (det d e b)) (sign (det d e c))
                 (sign (det e a b)) (sign (det e b c)) (sign (det e c a)) is_gen).
  unfold adds_up in A. unfold hits, holds_origin, edge_adds.
  assert (goal : forall P Q : bool, P = true -> Q = true -> (P = true -> Q = true -> (hits d a b c =? holds_origin e a b c + edge_adds d e a b + edge_adds d e b c + edge_adds d e c a)%Z = true) ->
            hits d a b c = (holds_origin e a b c + (edge_adds d e a b + edge_adds d e b c + edge_adds d e c a))%Z).
  { intros P Q HP HQ H. specialize (H HP HQ). apply Z.eqb_eq in H. lia. }
  refine (goal _ _ _ _ A); clear A goal.
  - assert (imp : forall x y, (x == 0 -> y == 0) -> implb (is_null (sign x)) (is_null (sign y)) = true).
    { intros x y H. destruct (is_null (sign x)) eqn:N; [|reflexivity]. simpl. apply sign_null, H, null_sign, N. }
    assert (imp2 : forall x y z, (x == 0 -> y == 0 /\ z == 0) -> implb (is_null (sign x)) (is_null (sign y) && is_null (sign z)) = true).
    { intros x y z H. destruct (is_null (sign x)) eqn:N; [|reflexivity]. apply null_sign in N. destruct (H N). simpl. rewrite !sign_null by assumption. reflexivity. }
    assert (from_d : forall x, In x [a; b; c] -> det d e x == 0 -> on_line d x).
    { intros x x_in H. apply line; [simpl; auto | simpl in *; tauto | apply turned_pair; exact H]. }
    assert (from_e : forall x y, In x [a; b; c] -> In y [a; b; c] -> det e x y == 0 -> on_line x y).
    { intros x y x_in y_in. apply line; simpl in *; tauto. }
    unfold e_is_generic. rewrite !andb_true_iff.
    split; [split; [split; [split; [split; [split|]|]|]|]|].
    + apply imp2. intros H. apply from_d in H; [|simpl; auto]. split; from_line H.
    + apply imp2. intros H. apply from_d in H; [|simpl; auto]. split; from_line H.
    + apply imp2. intros H. apply from_d in H; [|simpl; auto]. split; from_line H.
    + apply imp2. intros H. apply from_e in H; [|simpl; auto|simpl; auto]. split; from_line H.
    + apply imp2. intros H. apply from_e in H; [|simpl; auto|simpl; auto]. split; from_line H.
    + apply imp2. intros H. apply from_e in H; [|simpl; auto|simpl; auto]. split; from_line H.
    + destruct (is_null (sign (det d e a))) eqn:Na; [|reflexivity]. destruct (is_null (sign (det d e b))) eqn:Nb; [|reflexivity].
      simpl. apply sign_null. apply null_sign, from_d in Na; [|simpl; auto]. apply null_sign, from_d in Nb; [|simpl; auto].
      apply (both_on_line d); assumption.
  - assert (minus_sign : forall x, CompOpp (sign x) = sign (- x)) by (intros; symmetry; apply sign_opposite; reflexivity).
    unfold relations. rewrite <- !sign_product, !minus_sign, !andb_true_iff.
    repeat split; apply may_cancel_sound; unfold det, dot, cross; simpl; ring.
Qed.

Lemma edge_adds_antisymmetric d e a b : edge_adds d e b a = (- edge_adds d e a b)%Z.
Proof.
  unfold edge_adds.
  rewrite (sign_opposite (det d b a) (det d a b)), (sign_opposite (det e b a) (det e a b)) by apply det_swap.
  destruct (sign (det d e a)), (sign (det d e b)), (sign (det d a b)), (sign (det e a b)); reflexivity.
Qed.

(** All pieces of the body are triangles. *)
Definition of_triangles (b : zbody) : Prop := forall f, In f (pieces (cut_faces b)) -> exists x y z, f = [[x; y; z]].

Section Independence.
Variable b : zbody.
Variable place_of : grid -> point.
Variable p : point.
Hypothesis body_b : check_body b = true.
Hypothesis closed : is_closed b = true.
Hypothesis triangles : of_triangles b.

Let seen_at (v : grid) : point := minus (place_of v) p.

Let edge_sum (d e : point) (f : zface) : Z := sum (fun s => edge_adds d e (seen_at (fst s)) (seen_at (snd s))) (edges f).

Let origin_in (e : point) (f : zface) : Z :=
  match f with [[x; y; z]] => holds_origin e (seen_at x) (seen_at y) (seen_at z) | _ => 0%Z end.

Lemma sum_of_loops (g : grid * grid -> Z) (loops : list (list grid)) : sum (fun t => sum g (edges [t])) loops = sum g (edges loops).
Proof.
  induction loops as [|l loops IH]; [reflexivity|]. cbn [sum]. rewrite IH.
  change (edges (l :: loops)) with (edges_of_loop l ++ edges loops). rewrite sum_app. f_equal.
  unfold edges; cbn [flat_map]. rewrite app_nil_r. reflexivity.
Qed.

(** The edges of the pieces cancel. *)
Lemma edges_cancel d e : sum (edge_sum d e) (pieces (cut_faces b)) = 0%Z.
Proof.
  set (g := fun x y => edge_adds d e (seen_at x) (seen_at y)).
  assert (anti : forall x y, g y x = (- g x y)%Z) by (intros x y; exact (edge_adds_antisymmetric d e (seen_at x) (seen_at y))).
  unfold is_closed in closed.
  assert (whole := cancel_sound g anti _ closed).
  rewrite <- whole. clear whole.
  assert (cuts : forall f, In f (cut_faces b) -> check_cut f = true)
    by (unfold check_body in body_b; apply andb_prop in body_b as (H & _); apply forallb_forall; exact H).
  clear closed triangles body_b. unfold pieces. induction (cut_faces b) as [|f fs IH]; [reflexivity|].
  cbn [flat_map]. rewrite !sum_app, IH by (intros; apply cuts; right; assumption). f_equal.
  specialize (cuts f (or_introl eq_refl)). destruct f as [loops [|t cut]].
  - unfold pieces_of_face. simpl. unfold edge_sum, g. lia.
  - unfold pieces_of_face. cbn [fst snd]. unfold check_cut in cuts. apply andb_prop in cuts as (_ & sums).
    rewrite (cut_sum g anti _ _ sums), sum_map. exact (sum_of_loops (fun s => g (fst s) (snd s)) (t :: cut)).
Qed.

Lemma sum_along d e ws : ~ same d (Vec 0 0 0) -> in_general e (d :: map seen_at (concat (map (@concat grid) (pieces (cut_faces b))))) ->
  Forall2 (adds p d) (pieces_at place_of b) ws -> sum (fun x => x) ws = sum (origin_in e) (pieces (cut_faces b)).
Proof.
  intros nonzero general all.
  assert (total : sum (fun x => x) ws = (sum (origin_in e) (pieces (cut_faces b)) + sum (edge_sum d e) (pieces (cut_faces b)))%Z).
  2: { rewrite edges_cancel in total. lia. }
  unfold pieces_at in all. unfold of_triangles in triangles. clear closed body_b.
  revert ws all triangles general. induction (pieces (cut_faces b)) as [|f fs IH]; intros ws all triangles general; inversion all; subst; [reflexivity|].
  cbn [sum]. rewrite (IH l'); [|assumption|intros; apply triangles; right; assumption|].
  2: { assert (fewer : forall q, In q (d :: map seen_at (concat (map (@concat grid) fs))) -> In q (d :: map seen_at (concat (map (@concat grid) (f :: fs))))).
       { intros q [<-|q_in]; [left; reflexivity|]. right. simpl. rewrite map_app. apply in_or_app. right. exact q_in. }
       intros q r q_in r_in. apply general; apply fewer; assumption. }
  assert (one : y = (origin_in e f + edge_sum d e f)%Z); [|lia].
  destruct (triangles f (or_introl eq_refl)) as (u & v & w & ->).
  destruct (adds_is_hits p d (place_of u) (place_of v) (place_of w) y) as (gen & <-); [assumption|].
  unfold origin_in, edge_sum. simpl edges. cbn [sum fst snd].
  rewrite (triangle_adds d e (minus (place_of u) p) (minus (place_of v) p) (minus (place_of w) p)); [|assumption| |assumption].
  - unfold seen_at, edges, edges_of_loop. simpl. lia.
  - assert (fewer : forall q, In q [d; seen_at u; seen_at v; seen_at w] -> In q (d :: map seen_at (concat (map (@concat grid) ([[u; v; w]] :: fs))))).
    { intros q [<-|[<-|[<-|[<-|[]]]]]; [left; reflexivity | right; left; reflexivity | right; right; left; reflexivity | right; right; right; left; reflexivity]. }
    intros q r q_in r_in. apply general; apply fewer; assumption.
Qed.

(** The winding number of a point in a closed body of triangles is one number: every generic ray gives it. *)
Theorem winding_is_unique w w' : winding (pieces_at place_of b) p w -> winding (pieces_at place_of b) p w' -> w = w'.
Proof.
  intros (d & ws & nonzero & all & <-) (d' & ws' & nonzero' & all' & <-).
  set (corners := map seen_at (concat (map (@concat grid) (pieces (cut_faces b))))).
  set (l := d :: d' :: corners).
  destruct (general_vector (flat_map (fun x => map (cross x) l) l)) as (e & general).
  assert (in_l : in_general e l).
  { intros x y x_in y_in flat_. apply general; [|exact flat_]. apply in_flat_map. exists x. split; [assumption|]. apply in_map. assumption. }
  rewrite (sum_along d e ws), (sum_along d' e ws'); try assumption; [reflexivity|..];
    intros x y [<-|x_in] [<-|y_in]; apply in_l; unfold l; solve [left; reflexivity | right; left; reflexivity | right; right; assumption].
Qed.
End Independence.

(** ** Inside or outside *)

Lemma hull_beyond m p f q : (forall v, In v f -> 0 < dot m (minus v p)) -> hull f q -> 0 < dot m (minus q p).
Proof.
  intros above at_q. induction at_q as [v q v_in qv|q r t s at_q IHq at_r IHr low high t_is].
  - rewrite qv. auto.
  - assert (E : dot m (minus t p) == (1 - s) * dot m (minus q p) + s * dot m (minus r p))
      by (rewrite t_is; unfold dot, minus, plus, times; simpl; ring).
    rewrite E. destruct (Qlt_le_dec 0 s); nra.
Qed.

Lemma adds_off_hull p d f w : adds p d f w -> ~ hull (concat f) p.
Proof.
  assert (self : forall m, dot m (minus p p) == 0) by (intros; unfold dot, minus; simpl; ring).
  intros [((m & _ & ahead) & _)|(n & h & u & high & _ & corners & _)] at_p.
  - assert (H := hull_beyond m p _ p ahead at_p). rewrite self in H. lra.
  - assert (H : 0 < dot n (minus p p)); [|rewrite self in H; lra].
    apply (hull_beyond n p (concat f)); [|assumption]. intros v v_in. destruct (corners v v_in) as (E & _). rewrite E. assumption.
Qed.

(** An accepted ray decides: the point is not on the surface, and its winding number is the sum and no other. *)
Theorem inside_is_decided up p d m b c w : check_body b = true -> is_closed b = true -> of_triangles b -> check_winding up p d m b c = Some w ->
  ~ surface (body_at (moved m b) b) (over up p) /\ forall w', winding (pieces_at (moved m b) b) (over up p) w' <-> w' = w.
Proof.
  intros body_b closed triangles accepted. assert (W := ray_sum_is_winding up p d m b c w body_b accepted). split.
  - intros at_p. destruct (surface_in_pieces b _ _ body_b at_p) as (piece & piece_in & in_hull).
    apply (Permutation.Permutation_in _ (body_is_whole b body_b)) in piece_in.
    destruct W as (d' & ws & _ & all & _). unfold pieces_at in all.
    revert ws all. induction (pieces (cut_faces b)) as [|f fs IH]; intros ws all; [contradiction|].
    inversion all; subst. destruct piece_in as [->|piece_in]; [|eauto].
    match goal with H : adds _ _ _ _ |- _ => apply adds_off_hull in H; apply H end.
    unfold image. rewrite <- concat_map. exact in_hull.
  - intros w'. split; [intros W'; exact (winding_is_unique b _ _ body_b closed triangles w' w W' W) | intros ->; exact W].
Qed.
