(** What the checker computes with: integers over a common denominator, so that no fraction is reduced on the way. *)
Require Import List ZArith QArith Lia Lqa Setoid Morphisms.
From Certificates Require Import Space.
Import ListNotations.

(** ** Equal fractions have equal images *)

#[global] Instance same_equivalence : Equivalence same.
Proof.
  split.
  - intros p. repeat split; reflexivity.
  - intros p q (?&?&?). repeat split; symmetry; assumption.
  - intros p q r (?&?&?) (?&?&?). repeat split; etransitivity; eassumption.
Qed.

Ltac by_coordinates := intros; unfold same, det, dot, cross, plus, minus, times in *; simpl in *;
  repeat match goal with H : _ /\ _ |- _ => destruct H end;
  repeat match goal with |- _ /\ _ => split end;
  repeat match goal with H : _ == _ |- _ => rewrite H; clear H end; try reflexivity.

#[global] Instance plus_same : Proper (same ==> same ==> same) plus.
Proof. repeat intro. by_coordinates. Qed.
#[global] Instance minus_same : Proper (same ==> same ==> same) minus.
Proof. repeat intro. by_coordinates. Qed.
#[global] Instance times_same : Proper (Qeq ==> same ==> same) times.
Proof. repeat intro. by_coordinates. Qed.
#[global] Instance dot_same : Proper (same ==> same ==> Qeq) dot.
Proof. repeat intro. by_coordinates. Qed.
#[global] Instance cross_same : Proper (same ==> same ==> same) cross.
Proof. repeat intro. by_coordinates. Qed.
#[global] Instance det_same : Proper (same ==> same ==> same ==> Qeq) det.
Proof. repeat intro. unfold det. rewrite H, H0, H1. reflexivity. Qed.

(** ** Integer vectors *)

Open Scope Z_scope.

Definition grid := vec Z.

(** The point that integers stand for over a denominator. *)
Definition over (d : positive) (v : grid) : point := Vec (vx v # d) (vy v # d) (vz v # d).

Definition zdot (p q : grid) : Z := vx p * vx q + vy p * vy q + vz p * vz q.
Definition zminus (p q : grid) : grid := Vec (vx p - vx q) (vy p - vy q) (vz p - vz q).
Definition zcross (p q : grid) : grid :=
  Vec (vy p * vz q - vz p * vy q) (vz p * vx q - vx p * vz q) (vx p * vy q - vy p * vx q).
Definition zdet (p q r : grid) : Z := zdot p (zcross q r).
Definition ztimes (s : Z) (p : grid) : grid := Vec (s * vx p) (s * vy p) (s * vz p).

(** What main.ml reads: integers over the denominators of a file. *)
Record zpose := Zpose { zrows : vec grid; zshift : grid; pose_unit : positive }.

Definition pose_of (m : zpose) : pose :=
  Pose (Vec (over (pose_unit m) (vx (zrows m))) (over (pose_unit m) (vy (zrows m))) (over (pose_unit m) (vz (zrows m))))
       (over (pose_unit m) (zshift m)).

(** The image of integers over [unit], as integers over [pose_unit m * unit]. *)
Definition zplace (m : zpose) (unit : positive) (v : grid) : grid :=
  let coordinate row t := zdot row v + t * Zpos unit in
  Vec (coordinate (vx (zrows m)) (vx (zshift m))) (coordinate (vy (zrows m)) (vy (zshift m)))
      (coordinate (vz (zrows m)) (vz (zshift m))).

Ltac by_integers := unfold Qminus, Qeq, Qplus, Qmult, Qopp; cbn [vx vy vz over Qnum Qden]; rewrite ?Pos2Z.inj_mul; ring.

Lemma zplace_is_place m unit v :
  same (over (pose_unit m * unit) (zplace m unit v)) (place (pose_of m) (over unit v)).
Proof.
  repeat split; unfold place, plus, dot, over, zplace, zdot, pose_of; cbn [vx vy vz rows shift]; by_integers.
Qed.

Lemma dot_over (d : grid) u v : (dot (over 1 d) (over u v) == zdot d v # u)%Q.
Proof. unfold dot, zdot, over; cbn [vx vy vz]. by_integers. Qed.

(** A vector from p, over the unit [up], to v, over [uv]; as integers over their product. *)
Definition seen (up : positive) (p : grid) (uv : positive) (v : grid) : grid :=
  zminus (ztimes (Zpos up) v) (ztimes (Zpos uv) p).

Lemma seen_over up p uv v : same (over (up * uv) (seen up p uv v)) (minus (over uv v) (over up p)).
Proof. repeat split; unfold seen, zminus, ztimes, minus, over; cbn [vx vy vz]; by_integers. Qed.

(** Signs do not depend on the units. *)
Lemma zdot_sign m u v : (dot (over 1 m) (over u v) ?= 0)%Q = (zdot m v ?= 0).
Proof. rewrite dot_over. unfold Qcompare. simpl. rewrite Z.mul_1_r. reflexivity. Qed.

Lemma det_over ua ub uc a b c : (det (over ua a) (over ub b) (over uc c) == zdet a b c # (ua * ub * uc))%Q.
Proof. unfold det, zdet, dot, zdot, cross, zcross, over; cbn [vx vy vz]. by_integers. Qed.

Lemma zdet_sign ua ub uc a b c : (det (over ua a) (over ub b) (over uc c) ?= 0)%Q = (zdet a b c ?= 0).
Proof. rewrite det_over. unfold Qcompare. simpl. rewrite Z.mul_1_r. reflexivity. Qed.

(** ** Faces that are the same points, written as other fractions *)

Definition same_loops (f g : face) : Prop := Forall2 (Forall2 same) f g.

Lemma zplaced_is_placed m unit (f : list (list grid)) :
  same_loops (map (map (over (pose_unit m * unit))) (map (map (zplace m unit)) f)) (map (map (place (pose_of m))) (map (map (over unit)) f)).
Proof.
  unfold same_loops. rewrite !map_map. induction f as [|l f IH]; simpl; constructor; auto.
  rewrite !map_map. clear. induction l; simpl; constructor; auto using zplace_is_place.
Qed.

Lemma same_list_symmetric f g : Forall2 same f g -> Forall2 same g f.
Proof. induction 1; constructor; [symmetry|]; assumption. Qed.

Lemma same_loops_symmetric f g : same_loops f g -> same_loops g f.
Proof. induction 1; constructor; auto using same_list_symmetric. Qed.

Lemma same_concat f g : same_loops f g -> Forall2 same (concat f) (concat g).
Proof. induction 1; simpl; [constructor | apply Forall2_app; assumption]. Qed.

Lemma same_in f g v : Forall2 same f g -> In v g -> exists w, In w f /\ same w v.
Proof.
  induction 1 as [|w x f g wx fg IH]; intros []; [subst; exists w; split; [left|]; auto|].
  destruct IH as (y & ? & ?); [assumption|]. exists y; split; [right|]; assumption.
Qed.

Lemma hull_same f g p q : Forall2 same f g -> same p q -> hull g p -> hull f q.
Proof.
  intros fg pq at_p. revert q pq. induction at_p as [v p inside pv|p q r s at_p IHp at_q IHq low high r_is]; intros t rt.
  - destruct (same_in f g v fg inside) as (w & in_f & wv). apply (Corner f w); [assumption|]. rewrite <- rt, pv, wv. reflexivity.
  - apply (Between f p q t s); auto; [apply IHp; reflexivity | apply IHq; reflexivity | rewrite <- rt; exact r_is].
Qed.

Lemma hull_incl f g p : incl f g -> hull f p -> hull g p.
Proof.
  intros fg at_p. induction at_p as [v p inside pv|p q r s at_p IHp at_q IHq low high r_is].
  - apply (Corner g v); auto.
  - apply (Between g p q r s); auto.
Qed.

(** A linear form on a hull is at most its largest value at the corners. *)
Lemma hull_below d m f p : hull f p -> (forall v, In v f -> dot d v <= m)%Q -> (dot d p <= m)%Q.
Proof.
  intros at_p below. induction at_p as [v p inside pv|p q r s at_p IHp at_q IHq low high r_is].
  - rewrite pv. auto.
  - assert (split_dot : (dot d r == (1 - s) * dot d p + s * dot d q)%Q)
      by (rewrite r_is; unfold dot, plus, times; simpl; ring).
    rewrite split_dot. nra.
Qed.

Lemma hull_has_a_corner f p : hull f p -> exists v, In v f.
Proof. induction 1; eauto. Qed.
