(** Points, bodies, surfaces and solids: what a certificate speaks about. Everything here is a definition; nothing is computed by the checker.
    Numbers are rationals. README.md beside this file puts each definition next to the project's text. *)
Require Import List QArith.
Import ListNotations.
Open Scope Q_scope.

(** ** Points and vectors *)

Record vec (T : Type) := Vec { vx : T; vy : T; vz : T }.
Arguments Vec {T}.
Arguments vx {T}.
Arguments vy {T}.
Arguments vz {T}.

Definition point := vec Q.

(** Fractions are equal as numbers, as 1/2 and 2/4. *)
Definition same (p q : point) : Prop := vx p == vx q /\ vy p == vy q /\ vz p == vz q.

Definition plus (p q : point) : point := Vec (vx p + vx q) (vy p + vy q) (vz p + vz q).
Definition minus (p q : point) : point := Vec (vx p - vx q) (vy p - vy q) (vz p - vz q).
Definition times (s : Q) (p : point) : point := Vec (s * vx p) (s * vy p) (s * vz p).
Definition dot (p q : point) : Q := vx p * vx q + vy p * vy q + vz p * vz q.
Definition cross (p q : point) : point :=
  Vec (vy p * vz q - vz p * vy q) (vz p * vx q - vx p * vz q) (vx p * vy q - vy p * vx q).

(** Six times the signed volume of the tetrahedron of the origin and three points. *)
Definition det (p q r : point) : Q := dot p (cross q r).

(** The least convex set that holds the corners. *)
Inductive hull (corners : list point) : point -> Prop :=
| Corner v p : In v corners -> same p v -> hull corners p
| Between p q r s : hull corners p -> hull corners q -> 0 <= s -> s <= 1 ->
    same r (plus (times (1 - s) p) (times s q)) -> hull corners r.

(** ** Pose: the exact affine image x -> M x + t *)

Record pose := Pose { rows : vec point; shift : point }.

Definition place (m : pose) (p : point) : point :=
  plus (Vec (dot (vx (rows m)) p) (dot (vy (rows m)) p) (dot (vz (rows m)) p)) (shift m).

(** ** Faces, bodies, surface *)

Definition loop := list point.
Definition face := list loop.
Definition body := list face.

Definition placed (m : pose) : body -> body := map (map (map (place m))).

(** The directed edges of a loop: from each corner to the next, and from the last to the first. *)
Fixpoint steps {T} (first : T) (corners : list T) : list (T * T) :=
  match corners with
  | [] => []
  | p :: rest => (p, match rest with [] => first | q :: _ => q end) :: steps first rest
  end.

Definition edges_of_loop {T} (l : list T) : list (T * T) := match l with [] => [] | p :: _ => steps p l end.
Definition edges {T} (f : list (list T)) : list (T * T) := flat_map edges_of_loop f.

Fixpoint sum {T} (term : T -> Z) (l : list T) : Z :=
  match l with [] => 0%Z | x :: xs => (term x + sum term xs)%Z end.

(** How the edge from a to b, both seen from a point, crosses the ray from the point along u, as one sees it against the direction n:
    1 from its right to its left, -1 the other way, 0 not at all. *)
Definition turn (n u a b : point) : Z :=
  match (det n u a ?= 0)%Q, (det n u b ?= 0)%Q, (det n a b ?= 0)%Q with
  | Lt, Gt, Gt => 1%Z
  | Gt, Lt, Lt => (-1)%Z
  | _, _, _ => 0%Z
  end.

Definition turns (n u : point) (f : face) (p : point) : Z :=
  sum (fun e => turn n u (minus (fst e) p) (minus (snd e) p)) (edges f).

(** In the face's plane, with normal n, p has winding number w about the loops: counted along a ray u whose line meets no corner. *)
Definition planar_winding (f : face) (p : point) (w : Z) : Prop :=
  exists n u, ~ same n (Vec 0 0 0) /\ dot n u == 0 /\ (forall v, In v (concat f) -> dot n (minus v p) == 0 /\ ~ det n u (minus v p) == 0) /\
              turns n u f p = w.

(** A face's points: its loops, and the points of its plane whose winding number is not 0. *)
Definition on_face (f : face) (p : point) : Prop :=
  (exists e, In e (edges f) /\ hull [fst e; snd e] p) \/ (exists w, planar_winding f p w /\ w <> 0%Z).

Definition surface (b : body) (p : point) : Prop := exists f, In f b /\ on_face f p.

(** ** Winding number *)

(** The ray from p along d passes by the hull of the face: a plane is between them. *)
Definition passes_by (f : face) (p d : point) : Prop :=
  exists m, dot m d <= 0 /\ forall v, In v (concat f) -> 0 < dot m (minus v p).

(** The ray from p along d meets the plane of the face, off its edges, in a point of winding number w about the loops, seen against the ray. *)
Definition crosses (f : face) (p d : point) (w : Z) : Prop :=
  exists n h u, 0 < h /\ 0 < dot n d /\ (forall v, In v (concat f) -> dot n (minus v p) == h /\ ~ det d u (minus v p) == 0) /\
                (forall e, In e (edges f) -> ~ det d (minus (fst e) p) (minus (snd e) p) == 0 \/
                                            0 < det d u (minus (fst e) p) * det d u (minus (snd e) p)) /\
                turns d u f p = w.

(** What the face adds to the winding number of p, counted along a generic ray. *)
Definition adds (p d : point) (f : face) (w : Z) : Prop := passes_by f p d /\ w = 0%Z \/ crosses f p d w.

(** The winding number of p in a body is defined by the sum along some generic ray. *)
Definition winding (b : body) (p : point) (w : Z) : Prop :=
  exists d ws, ~ same d (Vec 0 0 0) /\ Forall2 (adds p d) b ws /\ sum (fun x => x) ws = w.

(** The solid: the surface, and the points whose winding number is not 0. *)
Definition solid (b : body) (p : point) : Prop := surface b p \/ (exists w, winding b p w /\ w <> 0%Z).

(** ** Shells: faces that are connected by corners at a common place *)

(** From a corner of which P is known, face after face, to this one. *)
Inductive linked (b : body) (P : point -> Prop) : face -> Prop :=
| Linked_here f v : In f b -> In v (concat f) -> P v -> linked b P f
| Linked_on f g v w : linked b P f -> In g b -> In v (concat f) -> In w (concat g) -> same v w -> linked b P g.

(** P is known of a corner of each shell. *)
Definition every_shell (b : body) (P : point -> Prop) : Prop := forall f, In f b -> linked b P f.
