#include "app/cli/help_text.h"

namespace hazumi {

const char* const kHelpText =
    R"(Hazumi: keyframe animation with regions that swing by their own inertia

  hazumi [FILE]                         the editor, in a window
  hazumi --render OUT [options] FILE
  hazumi --bake OUT [options] FILE
  hazumi --export OUT [options] FILE
  hazumi --check [options] FILE...
  hazumi --info [options] FILE
  hazumi --flight [options] FILE
  hazumi --import CHARACTER --save OUT.kfa [options]
  hazumi --run SCRIPT [--size WxH] [FILE]

FILE is a project (.kfa); --render, --bake, --export, --info and --flight read
BVH, FBX, glTF, GLB and Collada as well.

Tasks
  --render OUT      draw frames as PNG pictures; OUT is a folder, or a name with
                    #### where the frame number goes
  --bake OUT        write the motion: OUT ends in .json or .csv; - is standard
                    output, as JSON
  --export OUT      write the motion for other programs: OUT ends in .bvh,
                    .gltf, .glb (with the figure's mesh), .csv, .json or .mp4
  --check           say of each file whether it can be animated, and if not, why
  --info            say what is in the file, and its events
  --flight          find the flights: take-off, apex, landing, the gravity that
                    the path of the centre of mass implies, and whether the
                    clip plays too slow or fast; how far the feet slide
  --import CHARACTER --save OUT.kfa
                    make a project of a character and its clip: BVH, FBX, glTF,
                    GLB or Collada; says what was guessed and what is dropped
  --run SCRIPT      edit the project, or a new one: SCRIPT is a JSON list of
                    operators, such as
                    {"op": "key.set", "curve": "r_knee", "frame": 5, "value": 1}
                    nothing is saved unless it says "file.save";
                    {"op": "capture", "path": "editor.png"} draws the editor,
                    without a display, --size wide and high (1280x800)
  --operators       list the operators and their parameters
  --schema          write the JSON schema of .kfa files
  --help, --version

Drawing, with --render and --export to .mp4
  --frames A..B     only these frames, or one: N               (default: all)
                    --frames counts output frames when --fps is given, and
                    belongs to --export of any format
  --size WxH        picture size in pixels, 16 to 16384        (1280x720)
                    of videos even: an odd one grows by a pixel
  --camera VIEW     front, back, left, right, top, three-quarter, or
                    EX,EY,EZ,TX,TY,TZ[,FOV]: eye and target in metres, angle
                    in degrees                  (the file's, or three-quarter)
  --samples N       samples a pixel, 1 or 4                    (4)
  --threads N       at most 2 are used: one draws, one writes  (2)
  --body LOOK       skin, capsules, or both: the capsules in a see-through skin;
                    figures without a skin are capsules        (skin)
  --ghosts N        a translucent figure every N frames        (none)
  --paths           draw the paths of centre of mass, hands, feet and head
  --marks           draw a ring at the pinned joint
  --tint            tint the joints that a dynamics region moves
  --frame-number    draw the frame number
  --no-shadow       draw no shadow

Reading files of other programs
  --clip NAME       which of its clips                         (the first)
  --up y|z          the axis that is up              (the file's, or guessed)
  --unit M          metres of its unit of length; or
  --height M        how tall the character is        (the file's, or guessed)
  --mass KG         of all of it                     (of a person so tall)
  --reduce DEG      keys only where they are needed, so that angles stay within
                    DEG degrees of the clip          (a key every frame)
  --limits L        clip: joints go a little farther than in the clip; none
  --no-skin         leave out its meshes
  --all-warnings    say all that is dropped or changed, not the first ten lines

Motion, with any task, instead of what the file and its regions say
  --method M        exact, or paper: the steps of the published method
  --tolerance DEG   of method exact: greatest error of an angle in a region, in
                    degrees, 1e-10 to 5
  --step S          of method paper: its step in seconds, 0.000001 to 1

Output
  --fps N           output frames a second, 0.1 to 10000, such as 60, 29.97 or
                    30000/1001; the motion is the same         (the file's)
                    with --render, --bake, --export, --info, --flight
  --bvh-up y|z      of --export to .bvh: the axis that is up   (y)
  --bvh-unit m|cm   of --export to .bvh: its unit of length    (cm)
  --timings         with --bake and --export to .json: reports carry
                    microseconds, off by default so that two are equal bytes
  --torques         with --bake and --export to .json and .csv: also the torque
                    that every joint needs, by inverse dynamics, and the force
                    that nothing supplies
  --json            with --check, --info, --flight: answer in JSON

Editor
  --trace           say in the end how many events changed the project and how
                    long they took until the picture was finished, and how many
                    frames playback showed, passed over, and showed late

Results go to standard output, progress and complaints to standard error.
Exit codes: 0 ok, 1 failed, 2 usage, 65 bad data, 66 no input, 73 cannot write,
130 interrupted.

Examples
  hazumi --render out/throw throw.kfa        out/throw/frame_0000.png and so on
  hazumi --render out/t_####.png --frames 5..15 --size 640x360 throw.kfa
  hazumi --bake motion.json --fps 60 jump.kfa
  hazumi --bake - jump.kfa | less
  hazumi --export throw.glb throw.kfa
  hazumi --export throw.mp4 --size 640x360 throw.kfa
  hazumi --check *.kfa
)";

}  // namespace hazumi
