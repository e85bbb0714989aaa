(* check CERTIFICATE [A [B]] [--given KEY=FILE]...: proves the answers of a certificate of `tetracone ... --certificate FILE`.
   Nothing here is proved: it reads files, numbers and JSON, finds what the certificate leaves to find (normals, rays in planes), and asks Core, which
   was extracted from Coq. Core judges; what is found wrongly here is refused there. README.md says what is trusted.
   Exit status: 0 all are proved, 1 one is refused, 2 bad input or a kind of answer that this checker has not. *)

exception Bad of string
exception Refused of string

let bad format = Printf.ksprintf (fun s -> raise (Bad s)) format
let need holds what = if not holds then raise (Refused what)
let need_form holds what = if not holds then raise (Bad what)

(* JSON: numbers are integers, keys are there once. *)

type json = Null | Bool of bool | Int of int | String of string | List of json list | Object of (string * json) list

let parse text =
  let at = ref 0 in
  let peek () = if !at < String.length text then text.[!at] else '\000' in
  let rec skip () = match peek () with ' ' | '\t' | '\n' | '\r' -> incr at; skip () | _ -> () in
  let expect c = if peek () = c then incr at else bad "byte %d: expected '%c'" !at c in
  let word w value =
    if !at + String.length w <= String.length text && String.sub text !at (String.length w) = w then (at := !at + String.length w; value)
    else bad "byte %d: no JSON" !at in
  let string () =
    expect '"';
    let out = Buffer.create 16 in
    let rec go () =
      if !at >= String.length text then bad "a string has no end";
      match text.[!at] with
      | '"' -> incr at
      | '\\' ->
          let c = if !at + 1 < String.length text then text.[!at + 1] else bad "a string has no end" in
          at := !at + 2;
          (match c with
           | '"' | '\\' | '/' -> Buffer.add_char out c
           | 'n' -> Buffer.add_char out '\n'
           | 't' -> Buffer.add_char out '\t'
           | 'u' ->
               need_form (!at + 4 <= String.length text) "a string has no end";
               (match int_of_string_opt ("0x" ^ String.sub text !at 4) with
                | Some n when Uchar.is_valid n -> Buffer.add_utf_8_uchar out (Uchar.of_int n)
                | _ -> bad "byte %d: no character" !at);
               at := !at + 4
           | _ -> bad "byte %d: an escape that is not known" !at);
          go ()
      | c when c < ' ' -> bad "byte %d: a control character" !at
      | c -> incr at; Buffer.add_char out c; go () in
    go ();
    Buffer.contents out in
  let rec value depth =
    need_form (depth < 5000) "it is nested too deeply";
    skip ();
    let v = match peek () with
      | '{' -> incr at; Object (items depth '}' (fun () -> skip (); let k = string () in skip (); expect ':'; (k, value (depth + 1))))
      | '[' -> incr at; List (items depth ']' (fun () -> value (depth + 1)))
      | '"' -> String (string ())
      | 't' -> word "true" (Bool true)
      | 'f' -> word "false" (Bool false)
      | 'n' -> word "null" Null
      | '-' | '0' .. '9' ->
          let from = !at in
          incr at;
          while (match peek () with '0' .. '9' | '.' | 'e' | 'E' | '+' | '-' -> true | _ -> false) do incr at done;
          let digits = String.sub text from (!at - from) in
          need_form (String.for_all (fun c -> c = '-' || ('0' <= c && c <= '9')) digits) "a number with a point is not a string";
          (match int_of_string_opt digits with Some n -> Int n | None -> bad "%s is no index" digits)
      | _ -> bad "byte %d: no JSON" !at in
    skip ();
    v
  and items : 'a. int -> char -> (unit -> 'a) -> 'a list = fun _ close item ->
    skip ();
    if peek () = close then (incr at; [])
    else
      let rec go found =
        let x = item () in
        skip ();
        if peek () = ',' then (incr at; go (x :: found)) else (expect close; List.rev (x :: found)) in
      go [] in
  let v = value 0 in
  if !at < String.length text then bad "byte %d: something stands after the end" !at;
  v

let keys entry required optional =
  match entry with
  | Object items ->
      let names = List.map fst items in
      if List.length (List.sort_uniq compare names) < List.length names then bad "a key is there twice";
      List.iter (fun k -> if not (List.mem k names) then bad "the key %s is missing" k) required;
      List.iter (fun k -> if not (List.mem k required || List.mem k optional) then bad "the key %s is not known here" k) names
  | _ -> bad "an entry is no object"

let get entry key =
  match entry with
  | Object items -> (match List.assoc_opt key items with Some v -> v | None -> bad "the key %s is missing" key)
  | _ -> bad "an entry is no object"

let has entry key = match entry with Object items -> List.mem_assoc key items | _ -> false
let rows = function List l -> l | _ -> bad "a list is missing"
let text = function String s -> s | _ -> bad "a text is missing"
let index count what = function Int n when 0 <= n && n < count -> n | _ -> bad "no such %s" what

(* Numbers *)

let is_digits s = s <> "" && String.for_all (fun c -> '0' <= c && c <= '9') s
let unsigned s = if s <> "" && (s.[0] = '-' || s.[0] = '+') then String.sub s 1 (String.length s - 1) else s

let fraction s =
  match String.split_on_char '/' s with
  | [n; d] when is_digits (unsigned n) && is_digits d ->
      let d = Z.of_string d in
      need_form (Z.sign d > 0) "a fraction divides by 0";
      let n' = Z.of_string (unsigned n) in
      Q.make (if n.[0] = '-' then Z.neg n' else n') d
  | _ -> bad "'%s' is no fraction" s

(* A decimal is the double nearest to it, by the C library's strtod, and that is a fraction. *)
let decimal s =
  let number = unsigned s in
  let mantissa, exponent = match String.index_opt (String.lowercase_ascii number) 'e' with
    | Some k -> (String.sub number 0 k, unsigned (String.sub number (k + 1) (String.length number - k - 1)))
    | None -> (number, "0") in
  let digits = String.concat "" (String.split_on_char '.' mantissa) in
  if not (is_digits digits && is_digits exponent && List.length (String.split_on_char '.' mantissa) <= 2) then bad "'%s' is not a number" s;
  let x = float_of_string s in
  if Float.abs x = infinity then bad "%s is beyond the doubles" s;
  Q.of_float x

let given = function
  | String s -> if String.contains s '/' then fraction s else decimal s
  | _ -> bad "a number is not a string"

let exact = function
  | String s when s <> "" && s.[0] <> '+' ->
      if String.contains s '/' then fraction s
      else if is_digits (unsigned s) then Q.of_bigint (Z.of_string s)
      else bad "'%s' is not an integer or a fraction" s
  | _ -> bad "a number is not an integer or a fraction"

let vector ?(number = exact) ?(size = 3) entry =
  let l = rows entry in
  need_form (List.length l = size) "a list has another number of numbers";
  List.map number l

(* Integers over a common unit *)

let unit_of numbers = List.fold_left (fun u (x : Q.t) -> Z.lcm u x.den) Z.one numbers
let times u (x : Q.t) = Z.mul x.num (Z.divexact u x.den)
let grid_of u = function [x; y; z] -> { Core.vx = times u x; vy = times u y; vz = times u z } | _ -> assert false
let whole v = grid_of (unit_of v) v
let ints x y z = { Core.vx = Z.of_int x; vy = Z.of_int y; vz = Z.of_int z }
let zero = ints 0 0 0
let direction entry = let m = whole (vector entry) in need (m <> zero) "a direction is 0"; m

(* The first good vector of the axes and of (1, s, s^2): each condition is against two values of s at most. *)
let find_vector good =
  let rec go s = if s > 100000 then raise (Refused "no ray in a face's plane was found") else let v = ints 1 s (s * s) in if good v then v else go (s + 1) in
  let first = List.find_opt good [ints 1 0 0; ints 0 1 0; ints 0 0 1] in
  match first with Some v -> v | None -> go 1

(* A normal of the corners' plane: none where they are on a line. *)
let normal_of corners =
  match corners with
  | [] -> None
  | p :: rest ->
      let ways = List.map (fun q -> Core.zminus q p) rest in
      (match List.find_opt (fun w -> w <> zero) ways with
       | None -> None
       | Some w -> List.find_opt (fun n -> n <> zero) (List.map (Core.zcross w) ways))

(* Files *)

let read_bytes path =
  let file = try open_in_bin path with Sys_error reason -> raise (Bad reason) in
  Fun.protect ~finally:(fun () -> close_in file) (fun () ->
    try really_input_string file (in_channel_length file) with Sys_error reason -> raise (Bad reason))

let words line =
  let line = match String.index_opt line '#' with Some k -> String.sub line 0 k | None -> line in
  List.filter (( <> ) "") (String.split_on_char ' ' (String.map (fun c -> if String.contains "\t\r\011\012" c then ' ' else c) line))

let lines_of data =
  let data = if String.length data >= 3 && String.sub data 0 3 = "\xef\xbb\xbf" then String.sub data 3 (String.length data - 3) else data in
  let ends = if String.contains data '\n' then '\n' else '\r' in  (* a lone CR ends a line where no line ends in LF *)
  List.filter (( <> ) []) (List.map words (String.split_on_char ends data))

let integer w = if is_digits w then (match int_of_string_opt w with Some n -> n | None -> bad "%s is too large" w) else bad "'%s' is not a count or an index" w
let given_word w = given (String w)

let rec take n l = if n = 0 then [] else match l with x :: rest -> x :: take (n - 1) rest | [] -> bad "a file ends too early"
let rec drop n l = if n = 0 then l else match l with _ :: rest -> drop (n - 1) rest | [] -> bad "a file ends too early"

let read_off lines =
  let behind n word = String.sub word n (String.length word - n) in
  let rec behind_keyword word =
    if String.starts_with ~prefix:"OFF" word then behind 3 word
    else if String.starts_with ~prefix:"ST" word then behind_keyword (behind 2 word)
    else if String.starts_with ~prefix:"C" word || String.starts_with ~prefix:"N" word then behind_keyword (behind 1 word)
    else bad "the file does not begin with OFF" in
  let lines = match lines with
    | (word :: _) :: _ when is_digits word -> lines  (* the keyword may be left out *)
    | (word :: counts) :: rest ->
      let counts = match behind_keyword word with "" -> counts | stuck -> stuck :: counts in
      if counts = [] then rest else counts :: rest
    | _ -> bad "a file ends too early" in
  let vertices, faces, rest = match lines with (v :: f :: _) :: rest -> (integer v, integer f, rest) | _ -> bad "an OFF file has no counts" in
  let at = List.map (fun line -> List.map given_word (take 3 line)) (take vertices rest) in
  (at, List.map (fun line -> [List.map integer (take (integer (List.hd line)) (List.tl line))]) (take faces (drop vertices rest)))

let read_obj lines =
  let vertices = ref [] and count = ref 0 and faces = ref [] and before = ref [] in
  let is_geometry line = List.mem (List.hd line) ["v"; "f"; "fo"; "q"] in
  List.iter (fun line ->
    (* A name may end in a backslash: a vertex or a face behind it is a statement of its own. *)
    let line = if !before <> [] && is_geometry line && not (is_geometry !before) then line else !before @ line in
    before := [];
    let last = List.nth line (List.length line - 1) in
    if last.[String.length last - 1] = '\\' then
      before := List.filter (( <> ) "") (List.mapi (fun k w -> if k = List.length line - 1 then String.sub w 0 (String.length w - 1) else w) line)
    else match line with
      | "v" :: numbers -> vertices := List.map given_word (take 3 numbers) :: !vertices; incr count
      | ("f" | "fo" | "q") :: corners ->
          let corner w =
            let n = List.hd (String.split_on_char '/' w) in
            if n <> "" && n.[0] = '-' then !count - integer (unsigned n) else integer n - 1 in
          faces := [List.map corner corners] :: !faces
      | _ -> ()) lines;
  (List.rev !vertices, List.rev !faces)

let sum_of vectors = List.fold_left (List.map2 Q.add) [Q.zero; Q.zero; Q.zero] vectors
let dot_of p q = List.fold_left Q.add Q.zero (List.map2 Q.mul p q)
let cross_of at i j = match at.(i), at.(j) with
  | [a; b; c], [x; y; z] -> let minor p s q r = Q.sub (Q.mul p s) (Q.mul q r) in [minor b z c y; minor c x a z; minor a y b x]
  | _ -> bad "a vertex has not three numbers"

(* TetGen's facets of several polygons; the first is the outer one. *)
let read_poly lines node_lines =
  let lines = ref lines in
  let next from = match !from with l :: rest -> from := rest; l | [] -> bad "a file ends too early" in
  let first_line = next lines in
  let nodes = if integer (List.hd first_line) > 0 then lines else ref (Lazy.force node_lines) in
  let count = if integer (List.hd first_line) > 0 then integer (List.hd first_line) else integer (List.hd (next nodes)) in
  let first = match !nodes with (w :: _) :: _ -> integer w | _ -> bad "a file ends too early" in
  let vertices = List.init count (fun _ -> List.map given_word (take 3 (drop 1 (next nodes)))) in
  let faces = List.init (integer (List.hd (next lines))) (fun _ ->
    let polygons, holes = match List.map integer (take (min 2 (List.length (List.hd !lines))) (next lines)) with
      | p :: h :: _ -> (p, h) | [p] -> (p, 0) | [] -> bad "a facet has no counts" in
    let loops = List.init polygons (fun _ ->
      let line = ref (next lines) in
      let corners = integer (List.hd !line) in
      while List.length !line <= corners do line := !line @ next lines done;
      List.map (fun w -> integer w - first) (take corners (List.tl !line))) in
    lines := drop holes !lines;
    loops) in
  let at = Array.of_list vertices in
  let area loop = sum_of (List.map2 (cross_of at) loop (drop 1 loop @ [List.hd loop])) in
  List.iter (fun loops ->
    if List.exists (List.exists (fun v -> v < 0 || v >= count)) loops || List.mem [] loops then bad "no such vertex";
    (* The program turns such loops, as they are seen where the outer one is largest. *)
    match List.map area loops with
    | outer :: inner ->
        let size k = Q.abs (List.nth outer k) in
        let axis = List.fold_left (fun best k -> if Q.gt (size k) (size best) then k else best) 0 [1; 2] in
        need (List.for_all (fun way -> Q.sign (Q.mul (List.nth outer axis) (List.nth way axis)) <= 0) inner) "a hole runs the same way round as the face; expected the other way"
    | [] -> bad "a facet has no polygon") faces;
  (vertices, faces)

let read_model path =
  let data = read_bytes path in
  let suffix = String.lowercase_ascii (Filename.extension path) in
  let lines = lines_of data in
  need_form (lines <> []) (path ^ " is empty");
  let of_three_corners (v, f) =
    need_form (List.for_all (List.for_all (fun loop -> List.length loop > 2)) f) (path ^ " has a face of less than three corners, which the program leaves out");
    (v, f, data) in
  match suffix with
  | ".off" -> of_three_corners (read_off lines)
  | ".obj" -> of_three_corners (read_obj lines)
  | ".poly" ->
      let beside = lazy (read_bytes (Filename.remove_extension path ^ ".node")) in
      let v, f = read_poly lines (lazy (lines_of (Lazy.force beside))) in
      (v, f, if Lazy.is_val beside then data ^ Lazy.force beside else data)
  | _ -> bad "%s is no .off, .obj or .poly file" path

(* Bodies *)

type body = {
  core : Core.zbody;
  corners : Core.grid array;  (* by the file's indices *)
  loops : int list list array;  (* of each face *)
  of_face : int list array;  (* Core's faces of a file's face: several where it is not planar *)
  first_piece : int array;
  shells : int array;  (* of each vertex, a vertex that names its shell; -1 for a vertex of no face *)
  is_closed : bool Lazy.t;
  is_planar : bool;  (* all faces are, so that none is what it is cut into *)
}

(* A loop without corners that are twice in a row: an edge from a vertex to itself is a point of the next one. *)
let without_repeats loop =
  let rec drop = function a :: (b :: _ as rest) when a = b -> drop rest | a :: rest -> a :: drop rest | [] -> [] in
  match drop loop with
  | first :: (_ :: _ as rest) when List.nth rest (List.length rest - 1) = first -> rest
  | short -> short

(* Loops with a common vertex are of one shell. *)
let shells_of count faces =
  let name = Array.make count (-1) in
  Array.iter (List.iter (List.iter (fun v -> name.(v) <- v))) faces;
  let rec root v = if name.(v) = v then v else begin
      name.(v) <- name.(name.(v));
      root name.(v)
    end in
  Array.iter (List.iter (fun loop -> List.iter (fun v -> name.(root v) <- root (List.hd loop)) loop)) faces;
  Array.init count (fun v -> if name.(v) < 0 then -1 else root v)

(* Each directed edge occurs as often as its reverse. *)
let is_balanced faces =
  let uses = Hashtbl.create 1000 in
  let use a b by = Hashtbl.replace uses (a, b) (by + Option.value ~default:0 (Hashtbl.find_opt uses (a, b))) in
  Array.iter (List.iter (fun loop ->
    List.iter2 (fun a b -> if a < b then use a b 1 else if b < a then use b a (-1)) loop (drop 1 loop @ [List.hd loop]))) faces;
  Hashtbl.fold (fun _ surplus ok -> ok && surplus = 0) uses true

let read_body entry path =
  keys entry [] ["file"; "sha256"; "vertices"; "faces"; "cut"; "groups"];
  let vertices, faces =
    if has entry "vertices" then begin
      need_form (not (has entry "file" || has entry "sha256")) "a body stands in the certificate and names a file, too";
      (List.map (vector ~number:given) (rows (get entry "vertices")),
       List.map (fun loops -> List.map (fun l -> List.map (function Int n -> n | _ -> bad "an index is missing") (rows l)) (rows loops)) (rows (get entry "faces")))
    end else begin
      let path = match path with Some p -> p | None -> bad "the certificate names a model file, which is not given" in
      let vertices, faces, data = read_model path in
      ignore (text (get entry "file"));
      need (Sha256.hex data = text (get entry "sha256")) (path ^ " is not the file that the certificate is about");
      (vertices, faces)
    end in
  let count = List.length vertices in
  let loops = Array.of_list faces in
  need_form (Array.length loops > 0) "a body has no face";
  let check v = if v < 0 || v >= count then bad "no such vertex" in
  Array.iter (fun f -> if f = [] || List.mem [] f then bad "a face has no corner"; List.iter (List.iter check) f) loops;
  let shells = shells_of count loops and is_balanced = lazy (is_balanced loops) in
  Array.iteri (fun f face -> loops.(f) <- List.map without_repeats face) loops;
  let unit = unit_of (List.concat vertices) in
  let corners = Array.of_list (List.map (grid_of unit) vertices) in
  let place = List.map (List.map (Array.get corners)) in
  let cuts = Array.make (Array.length loops) [] in
  if has entry "cut" then List.iter (fun row -> match rows row with
    | [f; i; j; k] ->
        let f = index (Array.length loops) "face" f in
        cuts.(f) <- List.map (index count "vertex") [i; j; k] :: cuts.(f)
    | _ -> bad "a row of a cut has not four numbers") (rows (get entry "cut"));
  let of_face = Array.make (Array.length loops) [] and first_piece = Array.make (Array.length loops) 0 in
  let is_planar = ref true and core_faces = ref [] and core_count = ref 0 and pieces = ref [] and piece_count = ref 0 in
  Array.iteri (fun f face ->
    let zface = place face and cut = place (List.rev cuts.(f)) in
    let all = List.concat zface in
    let is_flat = List.length (List.sort_uniq compare (List.concat face)) <= 3 || (match normal_of all with
      | None -> true
      | Some n -> List.for_all (fun v -> Z.equal (Core.zdot n (Core.zminus v (List.hd all))) Z.zero) all) in
    let add face = core_faces := face :: !core_faces; of_face.(f) <- !core_count :: of_face.(f); incr core_count in
    first_piece.(f) <- !piece_count + 1;
    if is_flat then add (zface, cut)
    else begin
      need (cut <> []) (Printf.sprintf "face %d is neither planar nor cut" f);
      need (Core.check_cut (zface, cut)) (Printf.sprintf "face %d is not what its triangles are" f);
      (* The triangles are the face. *)
      need (List.length cut <= List.length all + 2 * List.length zface - 4) (Printf.sprintf "face %d has more triangles than it takes" f);
      let turned = function [p; q; r] -> List.hd (List.sort compare [[p; q; r]; [q; r; p]; [r; p; q]]) | t -> t in
      let cycles = List.map turned cuts.(f) in
      need (not (List.exists (fun t -> List.mem (turned (List.rev t)) cycles) cuts.(f))) (Printf.sprintf "two triangles of face %d cancel" f);
      is_planar := false;
      List.iter (fun t -> add ([t], [])) cut
    end;
    List.iter (fun p -> pieces := p :: !pieces; incr piece_count) (if cut = [] then [zface] else List.map (fun t -> [t]) cut)) loops;
  let pieces = Array.of_list (List.rev !pieces) in
  let one k = Core.One (Z.of_int (k + 1), pieces.(k)) in
  let rec group = function
    | Object _ as entry ->
        keys entry ["steps"] [];
        let add (found, last) = function
          | Int n when n <> 0 && abs n <= Array.length pieces ->
              let more = if n > 0 then [last + n] else List.rev (List.init (-n) (fun k -> last + 1 + k)) in
              need_form (List.hd more < Array.length pieces) "there is no such piece";
              (List.rev_append (List.rev more) found, List.hd more)
          | _ -> bad "a step is none" in
        let found, _ = List.fold_left add ([], -1) (rows (get entry "steps")) in
        group (List (List.rev_map (fun k -> Int k) found))
    | List members -> need_form (members <> []) "a group is empty"; Core.Many (List.map group members)
    | k -> one (index (Array.length pieces) "piece" k) in
  let groups = if has entry "groups" then group (get entry "groups") else Core.Many [Core.Many (List.init (Array.length pieces) one)] in  (* no node of a cover opens it *)
  let core = { Core.cut_faces = List.rev !core_faces; unit0 = unit; groups } in
  need (Core.check_body core) "a cut is not legal, or a piece is in no group or in two";
  { core; corners; loops; of_face; first_piece; shells; is_closed = lazy (Lazy.force is_balanced && Core.is_closed core);
    is_planar = !is_planar }

let need_closed body = need (Lazy.force body.is_closed) "a body is not closed, and has no solid"

let identity = { Core.zrows = { Core.vx = ints 1 0 0; vy = ints 0 1 0; vz = ints 0 0 1 }; zshift = zero; pose_unit = Z.one }

let pose_over unit numbers =
  match List.map (times unit) numbers with
  | [a; b; c; x; d; e; f; y; g; h; i; z] ->
      let row vx vy vz = { Core.vx; vy; vz } in
      { Core.zrows = { Core.vx = row a b c; vy = row d e f; vz = row g h i }; zshift = row x y z; pose_unit = unit }
  | _ -> assert false

let pose_numbers entry =
  let numbers = vector ~number:given ~size:12 entry in
  let r = (pose_over (unit_of numbers) numbers).zrows in
  need_form (Z.sign (Core.zdet r.vx r.vy r.vz) <> 0) "a pose is flat";
  numbers

let pose numbers = pose_over (unit_of numbers) numbers

(* A body at a pose; its pieces are placed when a cover first needs them. *)
type place = { m : Core.zpose; body : body; all : Core.placed_body Lazy.t }

let at_place body m = { m; body; all = lazy (Core.place_body m body.core) }

(* Covers *)

let directions_of entry = Array.of_list (List.map direction (rows (get entry "directions")))

let rec cover_of directions = function
  | Int k -> Core.Along directions.(index (Array.length directions) "direction" (Int k))
  | List (String "a" :: parts) -> Core.Open_a (List.map (cover_of directions) parts)
  | List (String "b" :: parts) -> Core.Open_b (List.map (cover_of directions) parts)
  | List [String "t"; time; earlier; later] ->
      let t = exact time in
      Core.Cut_time ({ Core.qnum = t.num; qden = t.den }, cover_of directions earlier, cover_of directions later)
  | _ -> bad "a node of a cover is none"

(* A normal and a ray in the plane, for Core to judge. *)
let crossed place up p d f =
  let core = place.body.core in
  let corners = List.concat (List.map (List.map (Core.seen up p (Core.unit_at place.m core))) (Core.place_face place.m core f)) in
  match normal_of corners with
  | None -> raise (Refused "a ray crosses a face without a plane")
  | Some n ->
      let n = if Z.sign (Core.zdot n d) < 0 then Core.opposite n else n in
      let u = find_vector (fun u -> List.for_all (fun v -> Z.sign (Core.zdet d u v) <> 0) corners) in
      Core.Crossed (n, u)

let rec passage_of directions crossed node (group : Core.zface Core.group) =
  match node, group with
  | Int k, _ -> Core.Passes directions.(index (Array.length directions) "direction" (Int k))
  | String "crossed", Core.One (_, f) -> crossed f
  | String "touched", _ -> Core.Touched
  | List (String "b" :: parts), Core.Many members ->
      need (List.length parts = List.length members) "a member of a group is missing in the cover";
      Core.Open (List.map2 (passage_of directions crossed) parts members)
  | _ -> bad "a node of a cover is none"

(* The winding number of p that the entry's ray proves. *)
let need_winding entry place up p =
  need_closed place.body;
  let d = direction (get entry "ray") in
  let number = match get entry "winding" with Int n -> n | _ -> bad "a winding number is none" in
  let passage = passage_of (directions_of entry) (crossed place up p d) (get entry "cover") place.body.core.groups in
  (match Core.winding_at_place up p d (Lazy.force place.all) passage with
   | Some w -> need (Z.equal w (Z.of_int number)) "the winding number is another"
   | None -> raise (Refused "a ray is not generic, or not apart from a group"));
  (number, d, passage)

(* Witnesses *)

(* Why a face, placed, holds a point: none where it does not. *)
let holder_of face up x unit =
  let seen = List.map (List.map (Core.seen up x unit)) face in
  let on_edge (a, b) =
    if Core.zcross a b <> zero || Z.sign (Core.zdot a b) > 0 then None
    else
      let ratio p q = if Z.equal p q then None else
        let t = Q.make p (Z.sub p q) in Some (Core.On_edge (t.num, t.den)) in
      List.find_map Fun.id [ratio a.Core.vx b.Core.vx; ratio a.vy b.vy; ratio a.vz b.vz; if a = zero then Some (Core.On_edge (Z.zero, Z.one)) else None] in
  match List.find_map on_edge (Core.edges seen) with
  | Some h -> Some h
  | None ->
      let corners = List.concat seen in
      Option.map (fun n ->
        let in_plane w = Core.zcross n w in
        let w = find_vector (fun w -> List.for_all (fun v -> Z.sign (Core.zdet n (in_plane w) v) <> 0) corners) in
        Core.In_plane (n, in_plane w))
        (Option.bind (normal_of corners) (fun n -> if List.for_all (fun v -> Z.sign (Core.zdot n v) = 0) corners then Some n else None))

let holds place f point =
  let body = place.body and m = place.m in
  let f = index (Array.length body.loops) "face" f in
  let up = unit_of point in
  let x = grid_of up point in
  List.exists (fun k ->
    match Core.nth_face (Z.of_int k) body.core.cut_faces with
    | None -> false
    | Some face ->
        (match holder_of (Core.place_face m body.core face) up x (Core.unit_at m body.core) with
         | Some h -> Core.check_holds m body.core (Z.of_int k) h up x
         | None -> false)) body.of_face.(f)

let witness entry places optional =
  keys entry ["points"; "faces"] optional;
  match rows (get entry "points"), rows (get entry "faces") with
  | [p; q], [f; g] ->
      let p = vector p and q = vector q in
      need (holds places.(0) f p) "the face of A does not hold the point";
      need (holds places.(1) g q) "the face of B does not hold the point";
      List.fold_left Q.add Q.zero (List.map2 (fun x y -> let d = Q.sub x y in Q.mul d d) p q)
  | _ -> bad "a witness has not two points and faces"

(* Windings: those of vertices, by the body that has the vertex, and all as (point, body, number). *)

type winding = { of_vertex : (int * int * Core.corner_ray) option;  (* the body, the shell *)
                 point : Core.grid * Z.t; holder : int; number : int }

let read_winding places entry =
  keys entry ["in"; "ray"; "winding"; "directions"; "cover"] ["vertex"; "point"];
  need_form (has entry "vertex" <> has entry "point") "a winding number is of a vertex or of a point";
  let holder = match get entry "in" with String "a" -> 0 | String "b" -> 1 | _ -> bad "a winding number is in no body" in
  let other = places.(1 - holder) in
  if has entry "vertex" then begin
    let vertex = index (Array.length other.body.corners) "vertex" (get entry "vertex") in
    let shell = other.body.shells.(vertex) in
    need (shell >= 0) "a vertex is of no face";
    let corner = other.body.corners.(vertex) in
    let up = Core.unit_at other.m other.body.core and p = Core.zplace other.m other.body.core.unit0 corner in
    let number, ray, proof = need_winding entry places.(holder) up p in
    { of_vertex = Some (1 - holder, shell, { Core.corner; ray; proof }); point = (p, up); holder; number }
  end else begin
    let point = vector (get entry "point") in
    let up = unit_of point in
    let p = grid_of up point in
    let number, _, _ = need_winding entry places.(holder) up p in
    { of_vertex = None; point = (p, up); holder; number }
  end

let windings answer places = List.map (read_winding places) (rows (get answer "windings"))

(* The order in which faces are reached from the corners: face after face with a common corner. *)
let links body rays =
  let faces = Array.of_list (List.map (fun f -> List.concat (fst f)) body.core.Core.cut_faces) in
  let at = Hashtbl.create 1000 in
  let key (v : Core.grid) = (Z.hash v.vx, Z.hash v.vy, Z.hash v.vz) in
  Array.iteri (fun f corners -> List.iter (fun v -> Hashtbl.add at (key v) (f, v)) corners) faces;
  let done_ = Array.make (Array.length faces) false and queue = Queue.create () and steps = ref [] in
  let reach link v = List.iter (fun (f, w) -> if v = w && not done_.(f) then begin
      done_.(f) <- true; steps := (Z.of_int (f + 1), link) :: !steps; Queue.add f queue end) (Hashtbl.find_all at (key v)) in
  let seen = Hashtbl.create 1000 in
  List.iter (fun r -> reach (Core.Start r.Core.corner) r.corner) rays;
  while not (Queue.is_empty queue) do
    let f = Queue.pop queue in
    List.iter (fun v -> if not (Hashtbl.mem seen v) then begin Hashtbl.add seen v (); reach (Core.Next (Z.of_int (f + 1))) v end) faces.(f)
  done;
  List.rev !steps

let need_each_shell found places k inside =
  let known = List.filter_map (fun w -> match w.of_vertex with
    | Some (body, shell, ray) when body = k && (w.number <> 0) = inside -> Some (shell, ray)
    | _ -> None) found in
  let rays = List.map snd known and shells = List.map fst known in
  let is_known = Array.for_all (fun shell -> shell < 0 || List.mem shell shells) places.(k).body.shells in
  need (is_known && Core.shells_at_place inside (Lazy.force places.(k).all) (Lazy.force places.(1 - k).all) rays (links places.(k).body rays))
    (if inside then "a shell has no vertex that is known to be inside" else "a shell has no vertex that is known to be outside")

let some_vertex_inside found = List.exists (fun w -> w.of_vertex <> None && w.number <> 0) found

(* Answers *)

let need_gap ?(square = Q.zero) ?(strictly = false) answer places =
  let cover = cover_of (directions_of answer) (get answer "cover") in
  need (Core.gap_at_place square.Q.num square.den strictly (Lazy.force places.(0).all) (Lazy.force places.(1).all) cover) "two groups are not as far apart"

let pair = ["ask"; "question"; "pose_a"; "pose_b"; "answer"]
let cover_keys = ["directions"; "cover"]

let need_pair answer bodies =
  need_form (Array.length bodies = 2) "there are not two bodies";
  let solid = match get answer "question" with String "solid" -> true | String "surface" -> false | _ -> bad "there is no such question" in
  if solid then Array.iter need_closed bodies;
  solid

let places_of answer bodies names = Array.of_list (List.mapi (fun k name -> at_place bodies.(k) (pose (pose_numbers (get answer name)))) names)

let placed_pair answer bodies =
  let solid = need_pair answer bodies in
  (places_of answer bodies ["pose_a"; "pose_b"], solid)

let prove_apart ?square ?strictly answer places solid =
  need_gap ?square ?strictly answer places;
  if solid then begin
    let found = windings answer places in
    need_each_shell found places 0 false;
    need_each_shell found places 1 false
  end

(* The points are at most so far apart, or one solid holds a vertex of the other. *)
let prove_together answer places solid square =
  if has answer "witness" then need (Q.leq (witness (get answer "witness") places []) square) "the points are farther apart"
  else need (solid && some_vertex_inside (windings answer places)) "no vertex is inside of the other solid"

let prove_collide answer bodies =
  keys answer pair ("witness" :: "windings" :: cover_keys);
  let places, solid = placed_pair answer bodies in
  match get answer "answer" with
  | String "surfaces" ->
      keys answer ("witness" :: pair) [];
      need (Q.equal (witness (get answer "witness") places []) Q.zero) "the points are not one"
  | String "apart" ->
      keys answer (pair @ cover_keys @ if solid then ["windings"] else []) [];
      prove_apart answer places solid
  | String ("a_in_b" | "b_in_a" as said) when solid ->
      keys answer (("windings" :: pair) @ cover_keys) [];
      need_gap answer places;
      let held = if said = "a_in_b" then 0 else 1 in
      need (List.exists (fun w -> match w.of_vertex with Some (k, _, _) -> k = held && w.number <> 0 | None -> false) (windings answer places))
        "no shell is known to be inside"
  | _ -> bad "there is no such answer"

let prove_distance answer bodies =
  keys answer pair ("witness" :: "windings" :: cover_keys);
  let places, solid = placed_pair answer bodies in
  let square = exact (get answer "answer") in
  if Q.equal square Q.zero then prove_together answer places solid Q.zero
  else begin
    need (Q.equal (witness (get answer "witness") places []) square) "the points are not so far apart";
    need (Q.sign square > 0) "a square is negative";
    prove_apart ~square answer places solid
  end

let prove_within answer bodies =
  keys answer ("limit" :: pair) ("witness" :: "windings" :: cover_keys);
  let places, solid = placed_pair answer bodies in
  let limit = given (get answer "limit") in
  let square = Q.mul limit limit in
  match get answer "answer" with
  | Int 1 -> need (Q.sign limit >= 0) "a negative limit"; prove_together answer places solid square
  | Int 0 -> if Q.sign limit >= 0 then prove_apart ~square ~strictly:true answer places solid
  | _ -> bad "there is no such answer"

let prove_inside answer bodies =
  keys answer ["ask"; "point"; "answer"] ("face" :: "ray" :: "winding" :: cover_keys);
  need_form (Array.length bodies = 1) "there is not one body";
  let place = at_place bodies.(0) identity in
  need_closed place.body;
  let point = vector ~number:given (get answer "point") in
  match get answer "answer" with
  | Int 0 -> need (holds place (get answer "face") point) "the face does not hold the point"
  | Int (1 | -1 as said) ->
      let up = unit_of point in
      let number, _, _ = need_winding answer place up (grid_of up point) in
      need ((number <> 0) = (said = 1)) "the winding number says otherwise"
  | _ -> bad "there is no such answer"

(* No piece of the placed body is on o + s d for s >= 0, or up to the last s; pieces from number [first] may be there at the last. *)
let need_free entry place o d last first =
  let u = unit_of (o @ d) in
  let last = Option.map (fun (t : Q.t) -> { Core.qnum = t.num; qden = t.den }) last in
  let no_crossing _ = bad "a node of a cover is none" in
  let passage = passage_of (directions_of entry) no_crossing (get entry "cover") place.body.core.groups in
  need (Core.check_ray u (grid_of u o) (grid_of u d) last first place.m place.body.core passage) "the ray is not apart from a group"

let prove_ray answer bodies =
  keys answer ["ask"; "origin"; "direction"; "answer"] ("end" :: cover_keys);
  need_form (Array.length bodies = 1) "there is not one body";
  let body = bodies.(0) in
  let o = vector ~number:given (get answer "origin") and d = vector ~number:given (get answer "direction") in
  need_form (List.exists (fun x -> Q.sign x <> 0) d) "a direction is 0";
  let last = if has answer "end" then Some (given (get answer "end")) else None in
  let hit = match get answer "answer" with
    | Null -> None
    | hit -> keys hit ["face"; "t"] []; Some (index (Array.length body.loops) "face" (get hit "face"), exact (get hit "t")) in
  match hit, last with
  | None, Some t when Q.sign t < 0 -> ()
  | _ ->
      (match hit with
       | Some (f, t) ->
           need (Q.sign t >= 0 && (match last with Some e -> Q.leq t e | None -> true)) "the hit is not on the ray";
           need (holds (at_place body identity) (Int f) (List.map2 (fun x y -> Q.add x (Q.mul t y)) o d)) "the face does not hold the hit"
       | None -> ());
      let first = Option.map (fun (f, _) -> Z.of_int body.first_piece.(f)) hit in
      need_free answer (at_place body identity) o d (match hit with Some (_, t) -> Some t | None -> last) first

(* Motions: what Core takes, and the pose at a time. *)
let blend t = List.map2 (fun x y -> Q.add (Q.mul (Q.sub Q.one t) x) (Q.mul t y))

let line x y = let u = unit_of (x @ y) in (Core.line (pose_over u x) (pose_over u y), fun t -> blend t x y)

let turned_pose numbers =
  match numbers with
  | [w; x; y; z; sx; sy; sz] ->
      let open Q in
      let two = of_int 2 in
      let ww = w * w and xx = x * x and yy = y * y and zz = z * z in
      let n = ww + xx + yy + zz in
      [(ww + xx - yy - zz) / n; two * (x * y - w * z) / n; two * (x * z + w * y) / n; sx;
       two * (x * y + w * z) / n; (ww - xx + yy - zz) / n; two * (y * z - w * x) / n; sy;
       two * (x * z - w * y) / n; two * (y * z + w * x) / n; (ww - xx - yy + zz) / n; sz]
  | _ -> assert false

(* The quaternion is 0 at no time, so that the divisor of Core's motion is positive. *)
let rigid x y =
  let turn = take 4 and shift = drop 4 in
  let product p q = List.fold_left2 (fun sum a b -> Q.add sum (Q.mul a b)) Q.zero (turn p) (turn q) in
  let first = product x x and last = product y y and both = product x y in
  need_form (Q.sign first > 0 && Q.sign last > 0 && (Q.sign both > 0 || Q.lt (Q.mul both both) (Q.mul first last))) "a quaternion is 0 at some time";
  let forms part = let u = unit_of (part x @ part y) in (u, List.map2 (fun a b -> [times u a; times u b]) (part x) (part y)) in
  match forms turn, forms shift with
  | (_, [w; a; b; c]), (u, [sx; sy; sz]) -> (Core.rigid w a b c sx sy sz u, fun t -> turned_pose (blend t x y))
  | _ -> assert false

(* From what is given at both ends: poses, or quaternions with translations. *)
let motion_of start finish =
  if List.length (rows start) = 7 then rigid (vector ~number:given ~size:7 start) (vector ~number:given ~size:7 finish)
  else line (pose_numbers start) (pose_numbers finish)

(* No common point of the moving bodies from time 0 to the last; at the last itself only where it is not open. *)
let need_moving entry (last : Q.t) is_open motions bodies =
  let cover = cover_of (directions_of entry) (get entry "cover") in
  match List.map fst motions with
  | [a; b] ->
      need (Core.check_motion { Core.qnum = last.num; qden = last.den } is_open a bodies.(0).core b bodies.(1).core cover)
        "two groups are not apart all the time"
  | _ -> assert false

let places_at bodies numbers = Array.of_list (List.mapi (fun k n -> at_place bodies.(k) (pose n)) numbers)

(* The poses, A moved by a vector. *)
let poses_of answer shift =
  let moved = List.mapi (fun k x -> if k mod 4 = 3 then Q.add x (List.nth shift (k / 4)) else x) in
  [moved (pose_numbers (get answer "pose_a")); pose_numbers (get answer "pose_b")]

(* All shells are outside of the other body; those of body [inside] are inside. *)
let need_all_shells entry places inside =
  let found = windings entry places in
  List.iter (fun k -> need_each_shell found places k (inside = Some k)) [0; 1]

(* A body comes on lines to its pose; before, the surfaces share no point. *)
let need_way row bodies poses inside =
  keys row ["of"; "pose"; "directions"; "cover"; "windings"] [];
  let mover = match get row "of" with String "a" -> 0 | String "b" -> 1 | _ -> bad "there is no such body" in
  let start = List.mapi (fun k p -> if k = mover then pose_numbers (get row "pose") else p) poses in
  need_moving row Q.one true (List.map2 line start poses) bodies;
  need_all_shells row (places_at bodies start) inside

let need_plane m places k =
  need (Core.check_plane m places.(k).m places.(k).body.core places.(1 - k).m places.(1 - k).body.core) "the plane does not separate"

(* The interiors share no point. *)
let need_parted answer bodies poses =
  if has answer "plane" then need_plane (direction (get answer "plane")) (places_at bodies poses) 0
  else need_way (get answer "way") bodies poses None

(* For each pair of sides there is a point: whether it is inside of A, and of B. *)
let need_parts found wanted =
  let side holder p = List.find_map (fun w -> if w.holder = holder && w.point = p then Some (w.number <> 0) else None) found in
  List.iter (fun (a, b) -> need (List.exists (fun w -> side 0 w.point = Some a && side 1 w.point = Some b) found) "a part of the solids has no point") wanted

(* From a point to x the surface of body k is met at x at the earliest: the point, and its winding number in body k. *)
let need_approach entry places k x =
  keys entry ["winding"; "directions"; "cover"] [];
  let row = get entry "winding" in
  keys row ["in"; "point"; "ray"; "winding"; "directions"; "cover"] [];
  let w = read_winding places row in
  need (w.holder = k) "the point is not about this body";
  let y = vector (get row "point") in
  need_free entry places.(k) y (List.map2 Q.sub x y) (Some Q.one) (Some Z.one);
  (y, w.number)

(* Points outside of the other body lead up to a point of the inner one. *)
let need_border entry places inner =
  keys entry ["face"; "point"; "outside"] [];
  let x = vector (get entry "point") in
  need (holds places.(inner) (get entry "face") x) "the face does not hold its point";
  need (snd (need_approach (get entry "outside") places (1 - inner) x) = 0) "the segment does not begin outside"

(* Whenever A has a little way to go along the direction, the interiors share a point. *)
let need_just_before entry places along =
  keys entry ["point"; "in_a"; "in_b"] [];
  let x = vector (get entry "point") in
  let in_a, of_a = need_approach (get entry "in_a") places 0 x in
  let in_b, of_b = need_approach (get entry "in_b") places 1 x in
  need (of_a <> 0 && of_b <> 0) "a segment does not begin inside";
  (* The direction is a sum of multiples of both ways, none of them negative. *)
  let d = whole along and ahead = whole (List.map2 Q.sub in_a x) and behind = whole (List.map2 Q.sub x in_b) in
  let n = Core.zcross ahead behind in
  let is_along v = Z.sign (Core.zdot v d) > 0 && Core.zcross v d = zero in
  need
    (if n = zero then is_along ahead || is_along behind
     else Z.sign (Core.zdot n d) = 0 && Z.sign (Core.zdot (Core.zcross d behind) n) >= 0 && Z.sign (Core.zdot (Core.zcross ahead d) n) >= 0)
    "the segments do not lead along the direction"

(* All faces by the places of their corners, from the least one of each loop; a face that is not planar is its triangles. *)
let shapes places k =
  let unit_at p = Core.unit_at p.m p.body.core in
  let u = unit_at places.(1 - k) in
  let scaled (v : Core.grid) = { Core.vx = Z.mul u v.vx; vy = Z.mul u v.vy; vz = Z.mul u v.vz } in
  let rotations loop = List.mapi (fun n _ -> drop n loop @ take n loop) loop in
  let least loop = List.hd (List.sort compare (rotations (List.map scaled loop))) in
  let core = places.(k).body.core in
  List.sort compare (List.map (fun (face, _) -> List.sort compare (List.map least (Core.place_face places.(k).m core face))) core.Core.cut_faces)

let need_solids bodies =
  need_form (Array.length bodies = 2) "there are not two bodies";
  Array.iter need_closed bodies

let nowhere = [Q.zero; Q.zero; Q.zero]

let prove_relation answer bodies =
  keys answer ["ask"; "pose_a"; "pose_b"; "answer"] ("witness" :: "plane" :: "way" :: "ways" :: "border" :: "windings" :: cover_keys);
  need_solids bodies;
  let poses = poses_of answer nowhere in
  let places = places_at bodies poses in
  let parts wanted = need_parts (windings answer places) wanted in
  let a_alone = (true, false) and b_alone = (false, true) in
  match get answer "answer" with
  | String "meet" ->
      need (Q.equal (witness (get answer "witness") places []) Q.zero) "the points are not one";
      need_parted answer bodies poses;
      parts [a_alone; b_alone]
  | String "overlap" -> parts [(true, true); a_alone; b_alone]
  | String ("disjoint" | "inside" | "contains" as said) ->
      need_gap answer places;
      need_all_shells answer places (match said with "inside" -> Some 0 | "contains" -> Some 1 | _ -> None)
  | String ("covered_by" | "covers" as said) ->
      let inner = if said = "covered_by" then 0 else 1 in
      need_way (get answer "way") bodies poses (Some inner);
      need_border (get answer "border") places inner;
      parts [if inner = 0 then b_alone else a_alone]
  | String "equal" when has answer "ways" ->
      (match rows (get answer "ways") with
       | [of_a; of_b] -> need_way of_a bodies poses (Some 0); need_way of_b bodies poses (Some 1)
       | _ -> bad "there are not two ways")
  | String "equal" -> need (shapes places 0 = shapes places 1) "the faces are not the same"
  | _ -> bad "there is no such answer"

let prove_exit answer bodies =
  keys answer ["ask"; "pose_a"; "pose_b"; "direction"; "answer"] ["plane"; "way"; "windings"; "gone"; "before"; "overlap"];
  need_solids bodies;
  let along = vector ~number:given (get answer "direction") in
  let first, last = match vector ~size:2 (get answer "answer") with [f; l] -> (f, l) | _ -> assert false in
  need_form (List.exists (fun x -> Q.sign x <> 0) along && Q.sign first >= 0 && Q.leq first last) "the exits are not in order, or the direction is 0";
  let at s = poses_of answer (List.map (Q.mul s) along) in
  need_parted answer bodies (at first);
  if Q.sign first = 0 then need (Q.sign last = 0) "solids that overlap nowhere have no exit but 0" else begin
    let start = places_at bodies (at Q.zero) in
    need_parts (windings answer start) [(true, true)];
    let gone = get answer "gone" in
    keys gone ["until"; "directions"; "cover"; "windings"] [];
    let until = exact (get gone "until") in
    need (Q.sign until > 0) "the bodies do not part for ever";
    let far = at (Q.add last until) in
    let places = places_at bodies far in
    need_moving gone Q.one true (List.map2 line far (at last)) bodies;
    need_all_shells gone places None;
    need_plane (whole along) places 1;
    let before = rows (get answer "before") in
    need_form (List.length before = 2) "there are not two points";
    List.iteri (fun k row -> need_just_before row (places_at bodies (at (if k = 0 then first else last))) along) before
  end

let prove_depth answer bodies =
  keys answer ["ask"; "pose_a"; "pose_b"; "answer"; "vector"] ["plane"; "way"; "low"];
  need_solids bodies;
  let v = vector (get answer "vector") in
  need (Q.equal (List.fold_left (fun sum x -> Q.add sum (Q.mul x x)) Q.zero v) (exact (get answer "answer"))) "the translation has another length";
  need_parted answer bodies (poses_of answer v)

let prove_motion answer bodies =
  keys answer ["ask"; "question"; "from_a"; "to_a"; "from_b"; "to_b"; "answer"] ("witness" :: "windings" :: cover_keys);
  let solid = need_pair answer bodies in
  let motions = List.map (fun name -> motion_of (get answer ("from_" ^ name)) (get answer ("to_" ^ name))) ["a"; "b"] in
  let places_when t = places_at bodies (List.map (fun (_, at) -> at t) motions) in
  let start = places_when Q.zero in
  let lo, hi = match get answer "answer" with
    | Null -> (Q.one, None)
    | times -> (match vector ~number:given ~size:2 times with [lo; hi] -> (lo, Some hi) | _ -> assert false) in
  need_form (Q.sign lo >= 0 && Q.leq lo Q.one && (match hi with Some h -> Q.leq lo h && Q.leq h Q.one | None -> true)) "the times are not in order";
  let is_double x = Q.equal x (Q.of_float (Q.to_float x)) in
  need (match hi with Some h -> is_double lo && is_double h && Q.to_float h <= Float.succ (Q.to_float lo) | None -> true) "the times are not one double or neighbours";
  (match hi with
   | None -> need_form (not (has answer "witness")) "a witness of no contact"
   | Some hi when has answer "witness" ->
       let time = exact (get (get answer "witness") "time") in
       need (Q.leq lo time && Q.leq time hi) "the witness is not of its time";
       let places = places_when time in
       need (Q.equal (witness (get answer "witness") places ["time"]) Q.zero) "the points are not one"
   | Some hi ->
       need (solid && Q.sign hi = 0) "there is no witness";
       need (some_vertex_inside (windings answer start)) "no vertex is inside of the other solid");
  if hi <> Some Q.zero then begin
    need_moving answer lo (match hi with Some hi -> Q.equal lo hi | None -> false) motions bodies;
    if solid then need_all_shells answer start None
  end

(* Each answer is about its row of the file, of `asked` rows; one row serves all. A row is one number, or a vector or pose. *)
let need_given answers row_numbers asked key path =
  let said answer = match if key = "ray" then List (rows (get answer "origin") @ rows (get answer "direction")) else get answer key with
    | String word -> List [String word]
    | words -> words in
  let size = List.length (rows (said (List.hd answers))) in
  let rec chunks = function [] -> [] | l -> take 16 l :: chunks (drop 16 l) in
  let is_matrix chunk = List.for_all2 Q.equal (drop 12 chunk) [Q.zero; Q.zero; Q.zero; Q.one] in
  let split word = List.filter (( <> ) "") (String.split_on_char ',' word) in
  let numbers = List.map given_word (List.concat_map split (List.concat (lines_of (read_bytes path)))) in
  let is_square = size = 12 && List.mem (List.length numbers / 16) [1; asked] && List.length numbers mod 16 = 0 && List.for_all is_matrix (chunks numbers) in
  let numbers = if is_square then List.concat_map (take 12) (chunks numbers) else numbers in  (* matrices of four rows *)
  let count = List.length numbers in
  need_form (size > 0 && (count = size || (count mod size = 0 && count / size = asked))) (Printf.sprintf "%s has not %d numbers for each of %d rows" path size asked);
  let numbers = Array.of_list numbers in
  List.iter2 (fun row answer ->
    let at = if count = size then 0 else row * size in
    need (List.for_all2 Q.equal (vector ~number:given ~size (said answer)) (Array.to_list (Array.sub numbers at size)))
      (Printf.sprintf "answer %d is not about what %s says" row path)) row_numbers answers

let kinds = ["collide", prove_collide; "distance", prove_distance; "within", prove_within; "inside", prove_inside; "ray", prove_ray;
             "relation", prove_relation; "motion", prove_motion; "exit", prove_exit; "depth", prove_depth]

let rec show = function
  | Null -> "null"
  | Bool b -> string_of_bool b
  | Int n -> string_of_int n
  | String s -> "\"" ^ s ^ "\""
  | List l -> "[" ^ String.concat ", " (List.map show l) ^ "]"
  | Object l -> "{" ^ String.concat ", " (List.map (fun (k, v) -> "\"" ^ k ^ "\": " ^ show v) l) ^ "}"

let prove text_of models givens print =
  let certificate = parse text_of in
  keys certificate ["certificate"; "bodies"; "answers"] ["asked"];
  need_form (get certificate "certificate" = String "tetracone 1") "another version; expected tetracone 1";
  let entries = rows (get certificate "bodies") and answers = rows (get certificate "answers") in
  need_form (List.mem (List.length entries) [1; 2]) "there are not one or two bodies";
  need_form (answers <> []) "no answer is in it";
  (* Where some answers are left out, each has its row. *)
  let is_each = not (has certificate "asked") in
  let row_of k answer = if is_each then k else match get answer "row" with Int row -> row | _ -> bad "a row is no integer" in
  let numbers = List.mapi row_of answers in
  let asked = if is_each then List.length answers else match get certificate "asked" with Int count -> count | _ -> bad "a count is no integer" in
  let rec ascend low = function row :: rest -> low < row && ascend row rest | [] -> low < asked in
  need_form (ascend (-1) numbers) (Printf.sprintf "rows do not ascend from 0 to below %d" asked);
  let files = ref models in
  let next_file () = match !files with file :: rest -> files := rest; Some file | [] -> None in
  let bodies = Array.of_list (List.map (fun entry -> read_body entry (if has entry "vertices" then None else next_file ())) entries) in
  need_form (!files = []) "more model files than the certificate names";
  List.iter (fun word -> match String.index_opt word '=' with
    | Some k when List.mem (String.sub word 0 k) ["pose_a"; "pose_b"; "from_a"; "to_a"; "from_b"; "to_b"; "point"; "ray"; "limit"; "end"; "direction"] ->
        need_given answers numbers asked (String.sub word 0 k) (String.sub word (k + 1) (String.length word - k - 1))
    | _ -> bad "--given %s is unknown" word) givens;
  List.iter2 (fun row answer ->
    let ask = text (get answer "ask") in
    let answer = match answer with Object items when not is_each -> Object (List.filter (fun (key, _) -> key <> "row") items) | _ -> answer in
    (match List.assoc_opt ask kinds with Some proof -> proof answer bodies | None -> bad "an answer is to no question");
    let limits = match ask with
      | "exit" when rows (get answer "answer") <> [String "0"; String "0"] -> ", only that an exit begins at the first"
      | "depth" when get answer "answer" <> String "0" -> ", an upper bound"
      | "ray" when has answer "end" -> ", up to " ^ text (get answer "end")
      | _ -> "" in
    let limits = if Array.for_all (fun body -> body.is_planar) bodies then limits else limits ^ ", of faces that are not planar as they are cut here" in
    print (Printf.sprintf "%d %s %s %s proved%s" row ask (if has answer "question" then text (get answer "question") else "-") (show (get answer "answer")) limits))
    numbers answers;
  let proved = List.length answers in
  if proved < asked then Printf.eprintf "%d of %d questions have no proof in it\n%!" (asked - proved) asked

(* The status and what is said of it. *)
let judged text_of models givens print =
  match prove text_of models givens print with
  | () -> (0, "proved")
  | exception Refused reason -> (1, "refused: " ^ reason)
  | exception (Bad reason | Failure reason | Invalid_argument reason | Sys_error reason) -> (2, "bad input: " ^ String.map (fun c -> if c = '\n' then ' ' else c) reason)
  | exception (Stack_overflow | Out_of_memory | Not_found | Division_by_zero | Z.Overflow) -> (2, "bad input: it is not made as a certificate is")

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 1 lsl 21; space_overhead = 400 };  (* most of what is made is dropped at once *)
  let rec arguments files givens = function
    | "--given" :: word :: rest -> arguments files (word :: givens) rest
    | word :: rest -> arguments (word :: files) givens rest
    | [] -> (List.rev files, List.rev givens) in
  match arguments [] [] (List.tl (Array.to_list Sys.argv)) with
  | [], _ -> prerr_endline "check: expected CERTIFICATE [A [B]] [--given KEY=FILE]..., or - for a certificate a line on standard input"; exit 2
  | "-" :: models, givens ->
      let rec each status = match input_line stdin with
        | line -> let status', said = judged line models givens ignore in print_endline said; each (max status status')
        | exception End_of_file -> status in
      exit (each 0)
  | file :: models, givens ->
      let status, said = match read_bytes file with
        | data -> judged data models givens print_endline
        | exception Bad reason -> (2, "bad input: " ^ reason) in
      if status > 0 then prerr_endline (file ^ ": " ^ said);
      exit status
