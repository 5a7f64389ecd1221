//! Families of networks, the graphs that each is made of, and how a graph is recognised by its tensors.
//!
//! File names say nothing: exports name their files as they like, their tensors as the exporter does.

use serde::{Deserialize, Serialize};

use crate::models::onnx::Description;
use crate::models::{Port, difference};

/// Networks that one adapter can run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// SAM 2 and 2.1 as samexporter and its relatives write them.
    Sam2Samexporter,
    /// SAM 2 and 2.1 as the transformers exporter writes them.
    Sam2Transformers,
    /// SAM 1 and MobileSAM.
    Sam1,
    /// Depth Anything 1, 2 and 3 with one picture in and one plane out.
    DepthAnything,
    /// Zero123++ 1.1 and 1.2 in five graphs, and its ControlNet for normals as a sixth.
    Zero123pp,
}

/// What a family is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stage {
    Mask,
    Depth,
    Views,
}

impl Stage {
    pub fn name(self) -> &'static str {
        match self {
            Stage::Mask => "mask",
            Stage::Depth => "depth",
            Stage::Views => "six views",
        }
    }
}

/// A graph of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    Encoder,
    Decoder,
    Depth,
    ClipVision,
    VaeEncoder,
    UnetWrite,
    UnetRead,
    VaeDecoder,
    /// Draws the normals of six views.
    #[serde(rename = "controlnet")]
    ControlNet,
    /// No graph: the text encoder's output for "" and the ramp, a safetensors file.
    Prompt,
}

impl Role {
    pub fn name(self) -> &'static str {
        match self {
            Role::Encoder => "encoder",
            Role::Decoder => "decoder",
            Role::Depth => "depth",
            Role::ClipVision => "clip_vision",
            Role::VaeEncoder => "vae_encoder",
            Role::UnetWrite => "unet_write",
            Role::UnetRead => "unet_read",
            Role::VaeDecoder => "vae_decoder",
            Role::ControlNet => "controlnet",
            Role::Prompt => "prompt",
        }
    }
}

impl Family {
    pub const ALL: [Family; 5] =
        [Family::Sam2Samexporter, Family::Sam2Transformers, Family::Sam1, Family::DepthAnything, Family::Zero123pp];

    pub fn name(self) -> &'static str {
        match self {
            Family::Sam2Samexporter => "sam2-samexporter",
            Family::Sam2Transformers => "sam2-transformers",
            Family::Sam1 => "sam1",
            Family::DepthAnything => "depth-anything",
            Family::Zero123pp => "zero123pp",
        }
    }

    pub fn stage(self) -> Stage {
        match self {
            Family::Sam2Samexporter | Family::Sam2Transformers | Family::Sam1 => Stage::Mask,
            Family::DepthAnything => Stage::Depth,
            Family::Zero123pp => Stage::Views,
        }
    }

    /// All of these make a network.
    pub fn roles(self) -> &'static [Role] {
        match self {
            Family::Sam2Samexporter | Family::Sam2Transformers | Family::Sam1 => &[Role::Encoder, Role::Decoder],
            Family::DepthAnything => &[Role::Depth],
            Family::Zero123pp => {
                &[Role::ClipVision, Role::VaeEncoder, Role::UnetWrite, Role::UnetRead, Role::VaeDecoder, Role::Prompt]
            }
        }
    }

    /// A network may have these, too.
    pub fn optional_roles(self) -> &'static [Role] {
        match self {
            Family::Zero123pp => &[Role::ControlNet],
            _ => &[],
        }
    }
}

/// What a graph of a role takes and gives. Exporters differ in names: a role may have several contracts.
#[derive(Clone, Debug)]
pub struct Contract {
    pub family: Family,
    pub role: Role,
    pub inputs: Vec<Port>,
    /// Inputs that some exports have; the adapters feed them where they are.
    pub optional: Vec<Port>,
    pub outputs: Vec<Port>,
}

impl Contract {
    /// Lines of a diff, `-` wanted and `+` found; none when the graph fits.
    pub fn difference(&self, graph: &Description) -> Vec<String> {
        let mut inputs = self.inputs.clone();
        inputs.extend(self.optional.iter().filter(|o| graph.inputs.iter().any(|i| i.name == o.name)).cloned());
        difference(&graph.inputs, &graph.outputs, &inputs, &self.outputs)
    }
}

/// Tokens and channels of the sixteen reference tensors of Zero123++, in the order of the UNet's modules: down, up, mid.
pub const REFERENCES: [(usize, usize); 16] = [
    (4096, 320),
    (4096, 320),
    (1024, 640),
    (1024, 640),
    (256, 1280),
    (256, 1280),
    (256, 1280),
    (256, 1280),
    (256, 1280),
    (1024, 640),
    (1024, 640),
    (1024, 640),
    (4096, 320),
    (4096, 320),
    (4096, 320),
    (64, 1280),
];

/// `ref_00` … `ref_15`.
pub fn reference_name(i: usize) -> String {
    format!("ref_{i:02}")
}

/// Channels, height and width of what the ControlNet adds to the UNet's way down, twelve times, and to its middle.
pub const CONTROLS: [[usize; 3]; 13] = [
    [320, 120, 80],
    [320, 120, 80],
    [320, 120, 80],
    [320, 60, 40],
    [640, 60, 40],
    [640, 60, 40],
    [640, 30, 20],
    [1280, 30, 20],
    [1280, 30, 20],
    [1280, 15, 10],
    [1280, 15, 10],
    [1280, 15, 10],
    [1280, 15, 10],
];

/// `control_00` … `control_12`.
pub fn control_name(i: usize) -> String {
    format!("control_{i:02}")
}

/// Every contract that Orb has an adapter for.
pub fn contracts() -> Vec<Contract> {
    let mut all = Vec::new();
    let mut add = |family, role, inputs: Vec<Port>, optional: Vec<Port>, outputs: Vec<Port>| {
        all.push(Contract { family, role, inputs, optional, outputs });
    };
    sam(&mut add);
    for (input, output) in [
        ("pixel_values", "predicted_depth"),
        ("image", "depth"),
        ("pixel_values", "depth"),
        ("image", "predicted_depth"),
    ] {
        let picture = Port::free(input, &[None, Some(3), None, None]);
        add(Family::DepthAnything, Role::Depth, vec![picture], vec![], vec![Port::any(output)]);
    }
    zero123pp(&mut add);
    all
}

type Add<'a> = &'a mut dyn FnMut(Family, Role, Vec<Port>, Vec<Port>, Vec<Port>);

fn sam(add: Add) {
    let levels = |names: [&str; 3]| {
        vec![
            Port::new(names[0], &[1, 32, 256, 256]),
            Port::new(names[1], &[1, 64, 128, 128]),
            Port::new(names[2], &[1, 256, 64, 64]),
        ]
    };
    let (points, labels) =
        (Port::free("point_coords", &[None, None, Some(2)]), Port::free("point_labels", &[None, None]));
    let mask =
        vec![Port::free("mask_input", &[None, Some(1), Some(256), Some(256)]), Port::free("has_mask_input", &[None])];
    let size = Port::new("orig_im_size", &[2]);
    let planes = |name: &str| Port::free(name, &[None; 4]);

    let family = Family::Sam2Samexporter;
    let names = ["high_res_feats_0", "high_res_feats_1", "image_embed"];
    add(family, Role::Encoder, vec![Port::new("image", &[1, 3, 1024, 1024])], vec![], levels(names));
    let mut inputs = levels(names);
    inputs.extend([points.clone(), labels.clone()]);
    inputs.extend(mask.clone());
    // Older exports ask for the size and give full-size masks. The size may come as whole numbers.
    for size in [size.clone(), size.clone().integer()] {
        let outputs = vec![planes("masks"), Port::any("iou_predictions")];
        add(family, Role::Decoder, inputs.clone(), vec![size], outputs);
    }

    let family = Family::Sam2Transformers;
    let names = ["image_embeddings.0", "image_embeddings.1", "image_embeddings.2"];
    add(
        family,
        Role::Encoder,
        vec![Port::free("pixel_values", &[None, Some(3), Some(1024), Some(1024)])],
        vec![],
        levels(names),
    );
    let mut inputs = levels(names);
    inputs.extend([
        Port::free("input_points", &[None, None, None, Some(2)]),
        Port::free("input_labels", &[None; 3]).integer(),
    ]);
    let optional = vec![
        Port::free("input_boxes", &[None, None, Some(4)]),
        Port::free("input_masks", &[None, Some(1), Some(256), Some(256)]),
        Port { element: None, ..Port::free("has_mask_input", &[None]) },
    ];
    add(family, Role::Decoder, inputs, optional, vec![Port::any("pred_masks"), Port::any("iou_scores")]);

    let family = Family::Sam1;
    let embedding = Port::new("image_embeddings", &[1, 256, 64, 64]);
    // With preprocessing inside (a picture of any size), and without.
    let whole = Port { element: None, ..Port::free("input_image", &[None, None, Some(3)]) };
    for image in [whole, Port::free("input_image", &[None, Some(3), Some(1024), Some(1024)])] {
        add(family, Role::Encoder, vec![image], vec![], vec![embedding.clone()]);
    }
    let mut inputs = vec![embedding, points, labels, size];
    inputs.extend(mask);
    let outputs = vec![planes("masks"), Port::any("iou_predictions"), planes("low_res_masks")];
    add(family, Role::Decoder, inputs, vec![], outputs);
}

fn zero123pp(add: Add) {
    let family = Family::Zero123pp;
    let timestep = Port { element: None, ..Port::new("timestep", &[1]) };
    let text = Port::new("encoder_hidden_states", &[1, 77, 1024]);
    let mut graph = |role, inputs, outputs| add(family, role, inputs, vec![], outputs);
    graph(
        Role::ClipVision,
        vec![Port::new("pixel_values", &[1, 3, 224, 224])],
        vec![Port::new("image_embeds", &[1, 1024])],
    );
    graph(
        Role::VaeEncoder,
        vec![Port::new("sample", &[1, 3, 512, 512])],
        vec![Port::new("latent_parameters", &[1, 8, 64, 64])],
    );
    let written = REFERENCES.iter().enumerate().map(|(i, &(n, c))| Port::new(&reference_name(i), &[1, n, c]));
    graph(
        Role::UnetWrite,
        vec![Port::new("cond_sample", &[1, 4, 64, 64]), timestep.clone(), text.clone()],
        written.collect(),
    );
    let noisy = vec![Port::new("sample", &[1, 4, 120, 80]), timestep, text];
    let read = REFERENCES.iter().enumerate();
    let read = read.map(|(i, &(_, c))| Port::free(&reference_name(i), &[Some(1), None, Some(c)]));
    let inputs: Vec<Port> = noisy.iter().cloned().chain(read).collect();
    let prediction = vec![Port::new("v_prediction", &[1, 4, 120, 80])];
    graph(Role::UnetRead, inputs.clone(), prediction.clone());
    let controls = CONTROLS.iter().enumerate();
    let controls: Vec<Port> = controls.map(|(i, &[c, h, w])| Port::new(&control_name(i), &[1, c, h, w])).collect();
    graph(Role::UnetRead, inputs.into_iter().chain(controls.clone()).collect(), prediction);
    let picture = Port::new("control", &[1, 3, 960, 640]);
    graph(Role::ControlNet, noisy.into_iter().chain([picture]).collect(), controls);
    graph(
        Role::VaeDecoder,
        vec![Port::new("latent_sample", &[1, 4, 120, 80])],
        vec![Port::new("sample", &[1, 3, 960, 640])],
    );
}

/// The family and role whose contract a graph meets.
///
/// # Errors
/// The name of the nearest contract and the lines of the diff from it.
pub fn recognise(graph: &Description) -> Result<(Family, Role), (String, Vec<String>)> {
    let mut nearest = (String::new(), Vec::new());
    let mut best = None;
    for contract in contracts() {
        let lines = contract.difference(graph);
        if lines.is_empty() {
            return Ok((contract.family, contract.role));
        }
        // Most names in common.
        let wanted = contract.inputs.iter().chain(&contract.outputs);
        let known = wanted.filter(|w| graph.inputs.iter().chain(&graph.outputs).any(|p| p.name == w.name)).count();
        let score = 100 * known / (contract.inputs.len() + contract.outputs.len());
        if best.is_none_or(|b| score > b) {
            best = Some(score);
            nearest = (format!("{} {}", contract.family.name(), contract.role.name()), lines);
        }
    }
    Err(nearest)
}
