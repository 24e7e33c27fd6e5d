#include "ui/panels/dialogs/manual.h"

namespace hazumi::ui {

const std::vector<ManualPart>& ManualParts() {
  static const std::vector<ManualPart> parts = {
      {"What a dynamics region is",
       {"You pose a figure by keys. In a dynamics region, which is some joints for some frames, no "
        "key moves those joints: they swing by their own inertia and gravity, and begin as fast as "
        "your keys left them.",
        "So an arm is thrown by keys and flies by itself; when the region ends, the curves take it "
        "up again where it is, as fast as it is. Nothing jumps, and all other joints do what their "
        "keys say.",
        "Friction slows a joint down: the factor is what is left of its speed after 1/30 s. 1 is "
        "no friction, 0.8 is like a relaxed arm, 0 is frozen. Joints stop at their limits.",
        "A joint is limp unless it has muscle, which is among the region's properties. A spring "
        "pulls "
        "it to its keys, the stiffer the higher its frequency: a loose wrist has 1 Hz, a held arm "
        "4 Hz. A torque pushes as its keys say. Driven by its keys the joint moves as if it were "
        "not in the region, and the limp ones feel it. In the dope sheet the rows of joints have a "
        "sign of what moves them, and a region's bar is filled as high as its spring is strong: "
        "drag that edge up or down.",
        "What a region moves touches the scene, if that is on among the region's properties: an "
        "arm "
        "comes to lie on a table, and a figure whose root is in the region falls and slides as the "
        "friction of the ground says, which is among the properties of the object. A ball on a "
        "line marks the bars of such regions in the dope sheet. The root has a row there like any "
        "limb: painting all limbs takes it along, so that the body turns as it falls, and the "
        "right button on a bar takes its row out of the region.",
        "Scene > Forces adds what acts from outside, such as wind or a push, which is a blow at "
        "one instant. Joints in regions give way to them, and so does a figure that flies while it "
        "has a region; what keys move does not.",
        "Scene > Constraints keeps things together while a region moves one of them: a hand and a "
        "bar that it holds on to, two hands, a foot on a rope. A point lets them turn, a weld does "
        "not, and a distance is a rod between them. A gap closes in the frames that it is given, "
        "and a constraint breaks under more than it bears. In the viewport it is a line, dashed "
        "while the gap is open; under the mouse it says how hard it pulls. "
        "The right button on a wrist offers to hold on to what is clicked next."}},
      {"What holds the figure",
       {"Keyed: the root's keys say where the figure is. Pinned: a joint, such as a toe, stays "
        "where it is, and the figure turns about it. Gravity: the figure flies, lands and stands "
        "by itself.",
        "A joint can be held besides: its limb bends so that it stays in its place. The Scene menu "
        "begins each of these on the current frame. In the dope sheet they are bars like regions: "
        "drag them or their ends, double click to change them, X deletes the one that was "
        "clicked."}},
      {"Balls, boxes and jumps",
       {"Scene > Add ball puts a ball into the selected hand, or on the ground. Click it to select "
        "it; pulled in a hand it changes its place there and R turns it, on the ground its place "
        "is keyed. Its row in the dope sheet shows who has it: the end of a bar is where it is "
        "let go, Pass on gives it to the selected joint. A ball that touches the scene, which is "
        "among its properties, bounces and rolls then. Scene > Add mesh does the same with a "
        "thing of another program. Shift+A over the viewport opens all that can be added; while a "
        "box is drawn its edges can be typed, with Tab between them.",
        "T throws what a hand holds: point at where it is to come down and click; S chooses "
        "underarm, overarm or push. The arm is drawn back, throws, and swings on in a dynamics "
        "region; an arm that is drawn back already throws from there. On a throw T aims it again, "
        "over what stands in between.",
        "J begins a jump: point at where it is to land and click. Crouch, take-off, apex and "
        "landing become keys like any others; between take-off and landing gravity has the "
        "figure. On a frame of a jump J aims it again. How high is typed, for T and J alike."}},
      {"Working",
       {"Click a joint to select it, R turns it, I keys the pose as it is seen: of the selected "
        "joints, or all of it if none is. All you do can be "
        "undone. F3 finds whatever Hazumi can do by its name.",
        "The large diamond is the root. G moves it, and the legs bend so that the feet stay where "
        "they stand; with F the whole figure comes along. R turns the whole figure; with F the "
        "feet "
        "stay. Hands and feet can be pulled by their diamonds.",
        "The poses among the properties are there in every project: click one, or pull it to the "
        "right for a part of the way. Shift+E blends between the keys before and after. With "
        "Mirror "
        "on, above the figure, both sides are posed at once. With a hand or a foot selected its "
        "elbow or knee can be pulled round.",
        "The right button opens what can be done with a joint, an object, a bar, a key or a "
        "marker. In "
        "dialogs Tab leads on, arrows and Space choose, Enter does it.",
        "What a region computed is hatched and blue. The motion follows each of your edits at "
        "once; nothing has to be baked first.",
        "Skin, at the top of the viewport, shows the figure in its skin or as the capsules that "
        "the "
        "motion is computed with and that touch things. It is drawing only.",
        "Effort, at the top of the viewport, colours each joint by what the motion asks of its "
        "muscles, from green to red; over 100 % it is ringed and says how much. Torque, in the "
        "graph editor, draws the torque of the chosen joint below its curve, on the band of what "
        "its muscles can give.",
        "Where something is wrong with the motion the warning sign beside the properties turns "
        "orange. Its list leads there, and most of it is put right by a button."}},
      {"Many variations",
       {"A sweep makes many variations of a project, without a window: a sweep file names fields "
        "of "
        "the project and the values that each takes, and hazumi --sweep SWEEP.json --out FOLDER "
        "computes every combination, measures it and draws it, into the table sweep.csv and the "
        "sheet sheet.png. hazumi --fields lists the fields of a project; man hazumi describes the "
        "file, with an example.",
        "To choose among them open the project, then File > Open sweep and its sweep.csv: click a "
        "cell to see the project with its values, and Keep this cell keeps them."}},
      {"To other programs",
       {"File > Export writes the motion as BVH, glTF, a table, JSON or a video, and shows before "
        "it does what will be in the file and what will not. For Blender, Unreal and Unity glTF "
        "(.glb) is best: it has skeleton, meshes and motion, and says in its extras what was "
        "computed. Keys, masses and limits are in the project alone: keep it.",
        "Scene > Choose sound puts a sound to the motion. Its wave lies under the ruler, and "
        "videos have it; where it begins and how loud it is stand in the properties. "
        "Playback lets it be heard, and so does going from frame to frame.",
        "Scene > Choose reference shows a picture or a video behind everything or as a plane in "
        "the scene; the properties say where, how strong, and whether rendered pictures have "
        "it."}}};
  return parts;
}

}  // namespace hazumi::ui
